// README.md, ARTIFACT.md and docs/: what they show is what the programs print and draw, and what
// they link is there.
#include "tests/support/program.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <regex>

namespace {

namespace fs = std::filesystem;

const fs::path source = SOURCE_DIR;
const std::string readme = read_file(source / "README.md");

std::vector<fs::path> pages() {
    std::vector<fs::path> found{source / "README.md", source / "ARTIFACT.md",
                                source / "CHANGELOG.md"};
    for (const auto& entry : fs::directory_iterator(source / "docs"))
        if (entry.path().extension() == ".md") found.push_back(entry.path());
    return found;
}

/// The groups of all matches, one vector a match; the whole match comes first.
std::vector<std::vector<std::string>> matches(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::vector<std::vector<std::string>> found;
    for (std::sregex_iterator i(text.begin(), text.end(), regex), end; i != end; ++i)
        found.emplace_back(i->begin(), i->end());
    return found;
}

std::string without_end_blanks(const std::string& text) {
    return std::regex_replace(text, std::regex(" +\n"), "\n");
}

/// The contents of the fenced blocks whose fence says this.
std::vector<std::string> blocks(const std::string& text, const std::string& word) {
    std::vector<std::string> found;
    std::string block;
    bool inside = false;
    bool wanted = false;
    for (const std::string& line : lines_of(text)) {
        const bool fence = line.starts_with("```");
        if (fence && wanted) found.push_back(block);
        if (fence) {
            inside = !inside;
            wanted = inside && line == "```" + word;
            block.clear();
        } else if (wanted) {
            block += line + '\n';
        }
    }
    return found;
}

/// A command of a console block, and what it prints there.
struct Command {
    std::string line;
    std::string output;
};

std::vector<Command> commands_of(const std::string& page) {
    std::vector<Command> commands;
    for (const std::string& block : blocks(page, "console"))
        for (const std::string& line : lines_of(block)) {
            if (line.starts_with("$ "))
                commands.push_back({line.substr(2), ""});
            else
                commands.back().output += line + '\n';
        }
    return commands;
}

std::string table_of_counts() {
    const Outcome outcome = run(PLCHECK " --table " SOURCE_DIR "/certs/classification.plc");
    REQUIRE(outcome.status == 0);
    const std::size_t table = outcome.out.find("claim ");
    REQUIRE(table != std::string::npos);
    return outcome.out.substr(table, outcome.out.find("\n\n", table) + 1 - table);
}

} // namespace

TEST_CASE("the commands that a page shows print what it shows") {
    for (const fs::path& page : pages()) {
        const TemporaryFolder folder;
        for (const char* name : {"certs", "models"})
            fs::create_directory_symlink(source / name, folder / name);
        const std::string path = fs::path(PLCHECK).parent_path().string() + ':' +
                                 fs::path(PLPROVE).parent_path().string();
        const std::string start = "cd " + folder.path().string() +
                                  " && export XDG_CACHE_HOME=$PWD/cache && PATH=" + path +
                                  ":$PATH && ";
        for (const Command& command : commands_of(read_file(page))) {
            CAPTURE(page.string());
            CAPTURE(command.line);
            CHECK(without_end_blanks(run(start + command.line).out) == command.output);
        }
    }
}

TEST_CASE("docs/reproduce.md has the table that plcheck prints, and the README some of its lines") {
    const std::string table = table_of_counts();
    const std::string page = read_file(source / "docs/reproduce.md");
    CHECK(page.find("```\n" + table + "```\n") != std::string::npos);
    const std::vector<std::string> lines = lines_of(table);
    const std::vector<std::string> excerpts = blocks(readme, "");
    REQUIRE(excerpts.size() == 1);
    CHECK(excerpts[0].starts_with(lines[0] + '\n'));
    for (const std::string& line : lines_of(excerpts[0])) {
        CAPTURE(line);
        CHECK(std::ranges::count(lines, line) == 1);
    }
}

TEST_CASE("what the pages link is there") {
    for (const fs::path& page : pages())
        for (const auto& link : matches(read_file(page), R"re((?:\]\(|src=")([^)"#]+)[)"])re")) {
            if (link[1].starts_with("http")) continue;
            CAPTURE(page.string());
            CAPTURE(link[1]);
            CHECK(fs::exists(page.parent_path() / link[1]));
        }
}

TEST_CASE("the pictures are those that plprove draws") {
    const TemporaryFolder folder;
    const fs::path committed = source / "docs/pictures";
    CHECK(run((committed / "draw").string() + " " PLPROVE " " + folder.path().string()).status ==
          0);
    std::size_t pictures = 0;
    for (const auto& entry : fs::directory_iterator(committed)) {
        if (entry.path().extension() != ".svg") continue;
        CAPTURE(entry.path().string());
        ++pictures;
        CHECK(read_file(entry.path()) == read_file(folder / entry.path().filename().string()));
    }
    CHECK(pictures ==
          static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path()), {})));
}

TEST_CASE("the README is short, and prose has at most 100 columns") {
    CHECK(lines_of(readme).size() <= 150);
    for (const fs::path& page : pages()) {
        bool code = false;
        for (const std::string& line : lines_of(read_file(page))) {
            if (line.starts_with("```")) code = !code;
            if (code || line.starts_with("|")) continue;
            CAPTURE(page.string());
            CAPTURE(line);
            CHECK(line.size() <= 100);
        }
    }
}

TEST_CASE("checker, citation and change log have the version of the project") {
    const std::string version = run(PLCHECK " --version").out;
    CHECK(version.starts_with("plcheck " PROJECT_VERSION ", certificate format " FORMAT_VERSION
                              "\n"));
    CHECK(read_file(source / "CITATION.cff").find("\nversion: " PROJECT_VERSION "\n") !=
          std::string::npos);
    CHECK(read_file(source / "CHANGELOG.md").find("\n## " PROJECT_VERSION " ") !=
          std::string::npos);
}
