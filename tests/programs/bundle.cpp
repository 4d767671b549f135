// The bundle that is archived for decades, as its reader meets it: an empty folder, a compiler.
#include "tests/support/process.h"
#include "tests/support/program.h"

#include <doctest/doctest.h>
#include <sstream>
#include <vector>

namespace {

const std::string plprove = PLPROVE;
const std::string plcheck = PLCHECK;
const std::string source = SOURCE_DIR;

/// The indented lines of the README: what it says to type.
std::vector<std::string> commands_in(const std::string& readme) {
    std::vector<std::string> commands;
    std::istringstream lines(readme);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("    ")) commands.push_back(line.substr(4));
    return commands;
}

/// What both archives say to type where there is no Arb.
const std::string without_arb =
    "c++ -std=c++20 -O2 -I. checker/*.cpp checker/*/*.cpp -lgmpxx -lgmp -o plcheck";

/// A source folder that has what a bundle needs, and little else.
void make_project(const TemporaryFolder& folder) {
    for (const char* name : {"certs", "checker", "docs", "proofs", "LICENSE", "CITATION.cff"}) {
        if (!std::filesystem::exists(std::filesystem::path(source) / name)) continue;
        std::filesystem::copy(std::filesystem::path(source) / name, folder / name,
                              std::filesystem::copy_options::recursive);
    }
}

} // namespace

TEST_CASE("the bundle unpacks, builds and checks with what it brings along") {
    const TemporaryFolder folder;
    const std::string in_folder = "cd " + folder.path().string();
    REQUIRE(run(plprove + " bundle --source " + source + " -o " + (folder / "b").string()).status ==
            0);
    REQUIRE(run(in_folder + " && zstd -q -d -c b | tar -x && rm b").status == 0);
    REQUIRE(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);

    const std::string inside = in_folder + "/* && ";
    CHECK(run(inside + "sha256sum --check --strict --quiet SHA256SUMS").status == 0);
    CHECK(run(inside + "cd certs && sha256sum --check --strict --quiet SHA256SUMS").status == 0);

    const std::string listed = run(inside + "sort -k2 SHA256SUMS").out;
    for (const char* file :
         {"checker/file/reader.h", "checker/report/text.cpp", "proofs/degrees.md"})
        CHECK(listed.find(std::string("  ") + file + "\n") != std::string::npos);
    CHECK(listed.find("  tests/") == std::string::npos);

    // With Arb: what the README says to check is every certificate file.
    const std::vector<std::string> commands = commands_in(run(inside + "cat README").out);
    REQUIRE(commands.size() == 5);
    const std::string every_file =
        run(inside + "find . -name '*.plc' -not -path './certs/vectors/*' | sort").out;
    CHECK(run(inside + "echo_all() { printf './%s\\n' \"$@\" | grep '\\.plc$'; }; { echo_all " +
              commands[1] + "; echo_all " + commands[2] + "; } | sort")
              .out == every_file);
    const Outcome with_arb = run(inside + commands[0]);
    CAPTURE(with_arb.err);
    REQUIRE(with_arb.status == 0);
    CHECK(run(inside + "./plcheck certs/degrees/three-points.plc").status == 0);
    // Without Arb: as the archive of the checker alone is built, which is tested below.
    CHECK(commands[3] == without_arb);
}

TEST_CASE("the bundle depends on the files alone, not on their dates, rights or neighbours") {
    const TemporaryFolder folder;
    make_project(folder);
    const auto from_sources = run(plprove + " bundle -o - --source " + source);
    REQUIRE(from_sources.status == 0);
    REQUIRE(run("cd " + folder.path().string() +
                " && chmod 600 LICENSE && touch -d 2001-01-01 certs/FORMAT.md && "
                "touch proofs/left-over.vo checker/core")
                .status == 0);
    const auto from_copy = run("cd " + folder.path().string() + " && " + plprove + " bundle -o -");
    CHECK(from_copy.status == 0);
    const bool same = from_copy.out == from_sources.out;
    CHECK(same);
}

TEST_CASE(
    "the programs of proofs and the pages of docs come into the bundle, where there are any") {
    const TemporaryFolder folder;
    make_project(folder);
    const std::string in_folder = "cd " + folder.path().string() + " && ";
    REQUIRE(run(in_folder + "mkdir -p docs/pictures proofs/computations").status == 0);
    write_file(folder / "docs/page.md", "A page.\n");
    write_file(folder / "docs/pictures/one.svg", "<svg/>\n");
    write_file(folder / "proofs/computations/extra.cpp", "int main() {}\n");
    write_file(folder / "proofs/computations/extra.h", "// Extra.\n");
    write_file(folder / "proofs/computations/extra", "a program\n");
    const Outcome with = run(in_folder + plprove + " bundle -o - | zstd -q -d | tar -t");
    REQUIRE(with.status == 0);
    for (const char* file : {"docs/page.md", "docs/pictures/one.svg",
                             "proofs/computations/extra.cpp", "proofs/computations/extra.h"}) {
        CAPTURE(file);
        CHECK(with.out.find(std::string("/") + file + "\n") != std::string::npos);
    }
    CHECK(with.out.find("/proofs/computations/extra\n") == std::string::npos);
    REQUIRE(run(in_folder + "rm -r docs").status == 0);
    const Outcome without = run(in_folder + plprove + " bundle -o - | zstd -q -d | tar -t");
    CHECK(without.status == 0);
    CHECK(without.out.find("/docs/") == std::string::npos);
    CHECK(without.out.find("/checker/file/reader.h\n") != std::string::npos);
}

TEST_CASE("the archive of the checker alone unpacks, builds and checks its example") {
    const TemporaryFolder folder;
    const std::string in_folder = "cd " + folder.path().string() + " && ";
    const std::string pack = in_folder + plprove + " bundle --checker --source " + source;
    REQUIRE(run(pack).status == 0);
    const std::string name = "plcheck-" PROJECT_VERSION;
    CHECK(names_in(folder.path()) == name + ".tar.zst\n");
    REQUIRE(run(in_folder + "zstd -q -d -c " + name + ".tar.zst | tar -x").status == 0);

    const std::string inside = in_folder + "cd " + name + " && ";
    CHECK(run(inside + "sha256sum --check --strict --quiet SHA256SUMS").status == 0);
    CHECK(run(inside + "find . -name '*.plc'").out == "./example.plc\n");
    CHECK(run(inside + "cmp certs/FORMAT.md " + source + "/certs/FORMAT.md").status == 0);
    CHECK(run(inside + "test -e prover").status != 0);

    const std::vector<std::string> commands = commands_in(run(inside + "cat README").out);
    REQUIRE(commands.size() == 2);
    CHECK(commands[0] == without_arb);
    const Outcome build = run(inside + commands[0]);
    CAPTURE(build.err);
    REQUIRE(build.status == 0);
    const Outcome check = run(inside + commands[1]);
    CHECK(check.status == 0);
    CHECK(check.out.find("certified minimal, class 2394: 2*Pa/Pa/Pa + P/P/P") != std::string::npos);

    // Without Arb it replays all but the degree files.
    const std::string built = (folder / name / "plcheck").string();
    const Outcome fresh = run("cd " + source + " && " + built + " certs/*.plc");
    CHECK(fresh.status == 0);
    CHECK(fresh.out.find("143494 certificates hold") != std::string::npos);
    const Outcome installed = run("cd " + source + " && " + plcheck + " certs/*.plc");
    CHECK(fresh.out == installed.out);
    const Outcome degrees =
        run(in_folder + "printf 'plcert 2 degrees\n' >degrees.plc && " + built + " degrees.plc");
    CHECK(degrees.status == 1);
    CHECK(degrees.err == "degrees.plc:1: refused: this plcheck was built without Arb\n");
}

TEST_CASE("the archive of the checker depends on the sources alone") {
    const TemporaryFolder folder;
    make_project(folder);
    for (const char* name : {"CMakeLists.txt", "CMakePresets.json", "cmake", "packaging"})
        std::filesystem::copy(std::filesystem::path(source) / name, folder / name,
                              std::filesystem::copy_options::recursive);
    const std::string in_copy = "cd " + folder.path().string() + " && ";
    REQUIRE(run(in_copy + "find . -exec touch -d 2001-01-01 {} + && chmod 600 LICENSE && "
                          "touch checker/core prover.txt")
                .status == 0);
    const Outcome from_copy = run(in_copy + plprove + " bundle --checker -o -");
    const Outcome from_sources = run(plprove + " bundle --checker -o - --source " + source);
    REQUIRE(from_copy.status == 0);
    const bool same = from_copy.out == from_sources.out;
    CHECK(same);
}

TEST_CASE("a bundle is refused where a certificate has not the digest on file") {
    const TemporaryFolder folder;
    make_project(folder);
    const std::string command =
        plprove + " bundle --source " + folder.path().string() + " -o " + (folder / "b").string();
    CHECK(run(command).status == 0);
    write_file(folder / "certs/extra.plc", "plcert 2 problem\n");
    const Outcome extra = run(command);
    CHECK(extra.status == 1);
    CHECK(extra.err.find("certs/extra.plc is not the file whose digest") != std::string::npos);
    std::filesystem::remove(folder / "certs/extra.plc");
    std::filesystem::remove(folder / "certs/classification.plc");
    const Outcome missing = run(command);
    CHECK(missing.status == 1);
    CHECK(missing.err.find("names certs/classification.plc") != std::string::npos);
}

TEST_CASE("a bundle is made from the project's source folder only") {
    const TemporaryFolder folder;
    const Outcome outcome = run("cd " + folder.path().string() + " && " + plprove + " bundle");
    CHECK(outcome.status == 1);
    CHECK(outcome.err.find("not the project's source folder") != std::string::npos);
    CHECK(outcome.err.find("--source") != std::string::npos);
    CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("the old name of the command says the new one") {
    const Outcome outcome = run(plprove + " archive -o -");
    CHECK(outcome.status == 3);
    CHECK(outcome.out.empty());
    CHECK(outcome.err ==
          "plprove: the command `archive` is called `bundle` now: run `plprove bundle`\n");
}
