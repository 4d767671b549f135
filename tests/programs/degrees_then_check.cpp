// From degrees to certificates to what plcheck makes of them, with the programs as they are built.
#include "tests/support/program.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

namespace {

const std::string plprove = PLPROVE;
const std::string plcheck = PLCHECK;

std::size_t lines_with(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

} // namespace

TEST_CASE("the certificate of plprove degree holds for plcheck") {
    const TemporaryFolder folder;
    const std::string file = (folder / "file.plc").string();
    // Registration: five points fix two views, and each leaves 8 third cameras.
    const Outcome outcome = run(plprove + " degree --json '3*P/P/P + 2*-/P/P' -o " + file);
    REQUIRE(outcome.status == 0);
    const auto report = nlohmann::json::parse(outcome.out);
    CHECK(report["degree"] == 160);
    CHECK(report["certified"] == 160);
    CHECK(report["complete"] == true);
    const Outcome check = run(plcheck + " --json " + file);
    CHECK(check.status == 0);
    CHECK(nlohmann::json::parse(check.out)["files"][0]["degrees"][0]["certified_at_least"] == 160);
}

TEST_CASE("what a sweep certifies, plcheck has accepted, whatever the number of threads") {
    const TemporaryFolder folder;
    const std::string in_folder = "cd " + folder.path().string() + " && ";
    for (const char* threads : {"1", "3"})
        CHECK(run(in_folder + plprove +
                  " degrees --target 20 --classes 'pl0p points ..4' --threads " + threads + " -o " +
                  threads)
                  .status == 0);
    for (const char* file : {"degrees.plc", "degrees.csv"}) {
        const bool same = read_file(folder / "1" / file) == read_file(folder / "3" / file);
        CHECK(same);
    }
    CHECK(lines_with(read_file(folder / "1" / "degrees.csv"), ",at-least,certified,") == 0);
    const Outcome collected =
        run(in_folder + plcheck + " --json 1/degrees.plc >report && " + plprove +
            " degrees --collect --checked report -o 1 && " + plcheck + " 1/degrees.plc");
    CHECK(collected.status == 0);
    const std::size_t records = lines_with(read_file(folder / "1" / "degrees.plc"), "\ndegree ");
    CHECK(records > 5);
    CHECK(lines_with(read_file(folder / "1" / "degrees.csv"),
                     ",at-least,certified,plcheck: lower bound") == records);
}
