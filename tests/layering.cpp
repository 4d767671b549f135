// Which sources may include which: prover and checker share nothing; inside the prover a folder
// includes only what lies below it; inside the checker a claim needs only what README.md says. And
// how long the sources are.
#include <algorithm>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path root = SOURCE_DIR;

using Folders = std::vector<std::string>;

/// The folders of the checker that say whether a problem is minimal: each includes only those
/// before it.
const Folders minimal_tier{"file", "algebra", "cameras", "problem", "reasons", "minimal"};

/// The folders of the checker for other claims, and what each needs beside that tier. Nothing of
/// these includes what only presents: paper, report, command. What follows from several files needs
/// all claims, and replay.h, which is in no folder.
const std::map<std::string, Folders> other_claims{
    {"effort", {}},
    {"fibres", {}},
    {"model", {"effort", "fibres"}},
    {"degrees", {"effort", "fibres"}},
    {"registration", {}},
    {"counts", {}},
    {"permutations", {}},
    {"exactly", {"degrees"}},
    {"family", {"effort"}},
    {"general_degrees", {"effort", "family", "fibres", "degrees"}},
    {"general_bounds", {"effort", "family", "general_degrees"}},
    {"conclusion",
     {"degrees", "counts", "exactly", "family", "general_degrees", "general_bounds", "model",
      "permutations", "registration", ""}}};

/// The folders of prover/, from the bottom to the top.
const Folders layers{"system",      "format",    "geometry",     "cameras",   "problem",
                     "reasons",     "minimal",   "tracking",     "groups",    "monodromy",
                     "three_views", "model",     "generate",     "importers", "many_views",
                     "fibres",      "catalogue", "degree_sweep", "solver",    "estimator",
                     "drawing",     "library",   "scripts",      "cli"};

/// A line `#include "to"` in the file `from`; both are paths in the project.
struct Arrow {
    fs::path from;
    fs::path to;
};

std::string part(const fs::path& path, int index) {
    return std::next(path.begin(), index)->string();
}

std::size_t layer_of(const fs::path& path) {
    const auto found = std::ranges::find(layers, part(path, 1));
    INFO("add the folder of " << path.string() << " to the layers");
    REQUIRE(found != layers.end());
    return static_cast<std::size_t>(found - layers.begin());
}

void add_arrows_of(const fs::path& file, std::vector<Arrow>& arrows) {
    const std::string start = "#include \"";
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        if (!line.starts_with(start)) continue;
        const std::string target = line.substr(start.size(), line.rfind('"') - start.size());
        arrows.push_back({file.lexically_relative(root), target});
    }
}

/// All quoted includes of the sources under a folder of the project.
std::vector<Arrow> arrows_of(const char* folder) {
    std::vector<Arrow> arrows;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        const std::string ending = entry.path().extension().string();
        if (ending == ".cpp" || ending == ".h" || ending == ".in")
            add_arrows_of(entry.path(), arrows);
    }
    REQUIRE(arrows.size() > 10);
    return arrows;
}

bool contains(const Folders& folders, const std::string& folder) {
    return std::ranges::find(folders, folder) != folders.end();
}

/// The folder inside the checker; empty for a file that is in none.
std::string folder_of(const fs::path& path) {
    return std::distance(path.begin(), path.end()) > 2 ? part(path, 1) : "";
}

bool is_source(const fs::path& path) {
    const std::string ending = path.extension().string();
    return ending == ".cpp" || ending == ".h";
}

std::size_t lines_in(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    REQUIRE(stream);
    return static_cast<std::size_t>(std::count(std::istreambuf_iterator<char>(stream), {}, '\n'));
}

/// The lines of all sources in a folder and the folders in it.
std::size_t lines_under(const fs::path& folder) {
    std::size_t lines = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && is_source(entry.path())) lines += lines_in(entry.path());
    return lines;
}

/// The folders of the checker that a line links.
Folders folders_linked_in(const std::string& line) {
    const std::regex link(R"(\]\((checker/[^)#]*)\))");
    Folders folders;
    for (std::sregex_iterator found(line.begin(), line.end(), link), end; found != end; ++found) {
        const fs::path target = std::string((*found)[1]);
        INFO(line);
        REQUIRE(fs::exists(root / target));
        if (fs::is_directory(root / target)) folders.push_back(part(target, 1));
    }
    return folders;
}

/// 1150 as `1,150`.
std::string with_comma(std::size_t number) {
    std::string digits = std::to_string(number);
    if (digits.size() > 3) digits.insert(digits.size() - 3, ",");
    return digits;
}

Folders folders_of_the_checker() {
    Folders folders;
    for (const auto& entry : fs::directory_iterator(root / "checker"))
        if (entry.is_directory()) folders.push_back(entry.path().filename().string());
    std::ranges::sort(folders);
    return folders;
}

} // namespace

TEST_CASE("prover and checker share no source") {
    for (const char* folder : {"prover", "checker"})
        for (const Arrow& arrow : arrows_of(folder)) {
            INFO(arrow.from.string() << " includes " << arrow.to.string());
            CHECK(part(arrow.to, 0) == folder);
        }
}

TEST_CASE("in a browser, too, the checker has no source of the prover") {
    for (const Arrow& arrow : arrows_of("atlas/wasm")) {
        INFO(arrow.from.string() << " includes " << arrow.to.string());
        const bool checker = arrow.from.filename() == "checker_module.cpp";
        const std::string to = part(arrow.to, 0);
        CHECK((checker ? to == "checker" : to == "prover" || to == "atlas"));
    }
}

TEST_CASE("no folder of the prover includes one above it") {
    for (const Arrow& arrow : arrows_of("prover")) {
        INFO(arrow.from.string() << " includes " << arrow.to.string());
        CHECK(layer_of(arrow.to) <= layer_of(arrow.from));
    }
}

TEST_CASE("what says whether a problem is minimal includes nothing else of the checker") {
    for (const Arrow& arrow : arrows_of("checker")) {
        INFO(arrow.from.string() << " includes " << arrow.to.string());
        const auto from = std::ranges::find(minimal_tier, folder_of(arrow.from));
        if (from == minimal_tier.end()) continue;
        const auto to = std::ranges::find(minimal_tier, folder_of(arrow.to));
        CHECK(to <= from);
    }
}

TEST_CASE("no claim of the checker needs another claim, or what only presents") {
    for (const Arrow& arrow : arrows_of("checker")) {
        INFO(arrow.from.string() << " includes " << arrow.to.string());
        const std::string from = folder_of(arrow.from), to = folder_of(arrow.to);
        const auto claim = other_claims.find(from);
        if (claim == other_claims.end()) continue;
        CHECK((to == from || contains(minimal_tier, to) || contains(claim->second, to)));
    }
}

TEST_CASE("each folder of the checker has its place in this test") {
    for (const std::string& folder : folders_of_the_checker()) {
        CAPTURE(folder);
        const bool presents = folder == "paper" || folder == "report" || folder == "command";
        CHECK((presents || contains(minimal_tier, folder) || other_claims.contains(folder)));
    }
}

TEST_CASE("only the report, the command and the library include what only presents") {
    for (const Arrow& arrow : arrows_of("checker")) {
        INFO(arrow.from.string() << " includes " << arrow.to.string());
        const std::string from = folder_of(arrow.from), to = folder_of(arrow.to);
        if (to == "paper") CHECK((from == "paper" || from == "report"));
        const std::string file = arrow.from.filename().string();
        const bool entry = file == "main.cpp" || file == "plcheck.cpp";
        if (to == "report") CHECK((from == "report" || entry));
        if (to == "command") CHECK((from == "command" || entry));
    }
}

TEST_CASE("no source of the checker has more than 350 lines") {
    for (const auto& entry : fs::recursive_directory_iterator(root / "checker")) {
        if (!entry.is_regular_file() || !is_source(entry.path())) continue;
        CAPTURE(entry.path().string());
        CHECK(lines_in(entry.path()) <= 350);
    }
}

TEST_CASE("who wants to know whether a problem is minimal, for any of nine kinds of cameras, reads "
          "at most 3,000 lines, and 600 on reasons why it is not") {
    std::size_t lines = 0;
    for (const std::string& folder : minimal_tier)
        if (folder != "reasons") lines += lines_under(root / "checker" / folder);
    CHECK(lines <= 3000);
    CHECK(lines_under(root / "checker" / "reasons") <= 600);
}

TEST_CASE("the README says how many lines stand behind each claim, and no folder behind two") {
    Folders linked;
    std::ifstream readme(root / "README.md");
    for (std::string line; std::getline(readme, line);) {
        const Folders folders = folders_linked_in(line);
        if (folders.empty()) continue;
        std::size_t lines = 0;
        for (const std::string& folder : folders)
            lines += lines_under(root / "checker" / folder);
        CAPTURE(line);
        CAPTURE(lines);
        CHECK(line.ends_with("| " + with_comma(lines) + " lines |"));
        linked.insert(linked.end(), folders.begin(), folders.end());
    }
    std::ranges::sort(linked);
    CHECK(linked == folders_of_the_checker());
}
