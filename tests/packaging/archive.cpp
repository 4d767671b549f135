// What docs/archive.md says to type, for the archive that is kept for decades and for the checker
// alone: in an empty folder, with a compiler.
#include "tests/packaging/installation.h"

#include <algorithm>
#include <doctest/doctest.h>

namespace {

namespace fs = std::filesystem;

const std::string without_arb =
    "c++ -std=c++20 -O2 -I. checker/*.cpp checker/*/*.cpp -lgmpxx -lgmp -o plcheck";
const std::string with_arb = "c++ -std=c++20 -O2 -DPLC_ARB -I. checker/*.cpp checker/*/*.cpp "
                             "-lflint-arb -lflint -lgmpxx -lgmp -o plcheck";

/// The blocks of the page that are fenced as a shell's: two that pack, each before one that unpacks
/// and builds.
std::vector<std::string> blocks() {
    const std::string page = read_file(SOURCE_DIR "/docs/archive.md"), fence = "```sh\n";
    std::vector<std::string> all;
    for (std::size_t at = page.find(fence); at != std::string::npos; at = page.find(fence, at)) {
        at += fence.size();
        all.push_back(page.substr(at, page.find("```", at) - at));
    }
    return all;
}

/// Packs the last commit as a block says, and moves the file to a folder.
void pack(const std::string& block, const std::string& name, const TemporaryFolder& folder) {
    const std::string file = (folder / name).string();
    std::string line = block;
    line.replace(line.find("-o " + name), 3 + name.size(), "-o " + file);
    const Outcome outcome = run("cd " SOURCE_DIR " && " + line);
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
}

/// The line of a block that compiles.
std::string compiler_line(const std::string& block) {
    for (const std::string& line : lines_of(block))
        if (line.starts_with("c++ ")) return line;
    return {};
}

bool has_history() {
    const bool has = run("git -C " SOURCE_DIR " rev-parse HEAD").status == 0;
    if (!has) MESSAGE("left out: the sources are in no repository");
    return has;
}

} // namespace

TEST_CASE("the archive unpacks, and its page names every certificate that it has") {
    if (!has_history()) return;
    const std::vector<std::string> page = blocks();
    REQUIRE(page.size() == 4);
    const TemporaryFolder folder;
    pack(page[0], "point-line-certificates.tar.gz", folder);
    REQUIRE(run("cd " + folder.path().string() + " && tar -xzf *.tar.gz").status == 0);
    const std::string inside = "cd " + (folder / "point-line-certificates").string() + " && ";
    CHECK(run(inside + "cd certs && sha256sum --check --strict --quiet SHA256SUMS").status == 0);
    // With Arb the same sources are built as without it, which the next test does.
    CHECK(compiler_line(page[1]) == with_arb);
    CHECK(compiler_line(page[3]) == without_arb);
    // The lines that replay name every file of certificates.
    std::vector<std::string> replayed;
    for (const std::string& line : lines_of(page[1]))
        if (line.starts_with("./plcheck"))
            for (const std::string& word : lines_of(run(inside + "printf '%s\\n' " + line).out))
                if (word.ends_with(".plc")) replayed.push_back(word);
    std::ranges::sort(replayed);
    const std::string all = "find certs -name '*.plc' -not -path 'certs/vectors/*' | LC_ALL=C sort";
    CHECK(replayed == lines_of(run(inside + all).out));
    CHECK(!fs::exists(folder / "point-line-certificates" / "prover"));
}

TEST_CASE("the archive of the checker alone builds without Arb, and CMake takes it") {
    if (!has_history()) return;
    const std::vector<std::string> page = blocks();
    REQUIRE(page.size() == 4);
    const TemporaryFolder folder;
    pack(page[2], "plcheck.tar.gz", folder);
    REQUIRE(run("cd " + folder.path().string() + " && tar -xzf *.tar.gz").status == 0);
    const std::string inside = "cd " + (folder / "plcheck").string() + " && ";
    std::string fast = without_arb; // the compiler takes a third of the time without -O2
    fast.replace(fast.find(" -O2 "), 5, " ");
    const Outcome build = run(inside + fast);
    CAPTURE(build.err);
    REQUIRE(build.status == 0);
    CHECK(run(inside + "test -e prover").status != 0);
    CHECK(run(inside + "cmake --preset checker-only").status == 0);
    // It says what the other plcheck says, of all but approximate solutions.
    const std::string built = (folder / "plcheck/plcheck").string();
    const Outcome fresh = run("cd " SOURCE_DIR " && " + built + " certs/*.plc");
    CHECK(fresh.status == 0);
    CHECK(fresh.out.find("143494 certificates hold") != std::string::npos);
    CHECK(fresh.out == run("cd " SOURCE_DIR " && " BUILD_DIR "/bin/plcheck certs/*.plc").out);
    const Outcome degrees = run(inside + "sed '/^real/q;/^pair/q' " SOURCE_DIR
                                         "/certs/degrees/small.plc >degrees.plc && "
                                         "./plcheck degrees.plc");
    CHECK(degrees.status == 1);
    CHECK(degrees.err.find("this plcheck was built without Arb: see --version\n") !=
          std::string::npos);
}
