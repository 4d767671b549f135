// Which sources may include which: prover and checker share nothing, and inside the prover a folder
// includes only what lies below it.
#include <algorithm>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path root = SOURCE_DIR;

/// The folders of prover/, from the bottom to the top.
const std::vector<std::string> layers{
    "system",    "format",       "problem", "geometry", "classification", "bounds", "degree",
    "catalogue", "degree_sweep", "drawing", "scripts",  "bundle",         "cli"};

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

} // namespace

TEST_CASE("prover and checker share no source") {
    for (const char* folder : {"prover", "checker"})
        for (const Arrow& arrow : arrows_of(folder)) {
            INFO(arrow.from.string() << " includes " << arrow.to.string());
            CHECK(part(arrow.to, 0) == folder);
        }
}

TEST_CASE("no folder of the prover includes one above it") {
    for (const Arrow& arrow : arrows_of("prover")) {
        INFO(arrow.from.string() << " includes " << arrow.to.string());
        CHECK(layer_of(arrow.to) <= layer_of(arrow.from));
    }
}
