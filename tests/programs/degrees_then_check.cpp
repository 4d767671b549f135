// From degrees to certificates to what plcheck makes of them, with the programs as they are built.
#include "tests/support/programs.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

namespace {

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
    CHECK(report["certificate"] == 160);
    CHECK(!report.contains("certified")); // plcheck has not been asked yet
    CHECK(report["complete"] == true);
    const Outcome check = run(plcheck + " --json " + file);
    CHECK(check.status == 0);
    CHECK(nlohmann::json::parse(check.out)["files"][0]["degrees"][0]["certified_at_least"] == 160);
}

TEST_CASE("the degree of the five-point problem follows from what plcheck certifies") {
    const TemporaryFolder folder;
    const std::string file = (folder / "five.plc").string();
    const Outcome outcome = run(plprove + " degree --json five-point -o " + file);
    REQUIRE(outcome.status == 0);
    const auto report = nlohmann::json::parse(outcome.out);
    CHECK(report["degree"] == 20);
    CHECK(report["essential_matrices"] == 10);
    const Outcome check = run(plcheck + " --json " + certs + "classification.plc " + certs +
                              "models/registrations/s_l0_i0_r5.plc " + file);
    CHECK(check.status == 0);
    const std::string number = std::to_string(report["extension"].get<int>());
    int solutions = 0;
    int third_cameras = 0;
    const auto checked = nlohmann::json::parse(check.out);
    for (const auto& claim : checked["degree_claims"]) {
        const std::string name = claim["claim"];
        if (name.starts_with("PL0P, class " + number + ":")) solutions = claim["certified_exactly"];
        if (name == "- registration of its third camera, class " + number)
            third_cameras = claim["certified_exactly"];
    }
    CHECK(solutions == report["extension_degree"]);
    REQUIRE(third_cameras == report["third_cameras"]);
    CHECK(solutions / third_cameras == report["degree"]);
    // What is on file says the same.
    const Outcome on_file = run(plprove + " problem --json five-point");
    const auto degree = nlohmann::json::parse(on_file.out)["degree"];
    CHECK(degree["value"] == report["degree"]);
    CHECK(degree["status"] == "certified");
}

TEST_CASE("the degree of a problem in two views is that of the five points it reduces to") {
    for (const char* spec : {"4*P/P + Pab/Pab", "5*P/P + a/b", "5*P/P + a/a + Pa/-"}) {
        CAPTURE(spec);
        const Outcome text = run(plprove + " degree '" + std::string(spec) + "'");
        CHECK(text.status == 0);
        CHECK(text.err.empty());
        CHECK(lines_with(text.out, "reduced     5*P/P\n") == 1);
        CHECK(lines_with(text.out, "degree      20 relative poses, by theorem") == 1);
        CHECK(lines_with(text.out, "4 third cameras for each relative pose") == 1);
    }
}

TEST_CASE("degree shows on a terminal how many solutions it has found, and wipes that") {
    if (run("command -v script").status != 0) {
        MESSAGE("there is no script(1) here: not tested");
        return;
    }
    const Outcome outcome = run("script -qec '" + plprove + " degree 2394' /dev/null");
    const std::size_t shown = lines_with(outcome.out, "\rfinding solutions: ");
    CHECK(shown > 3);
    CHECK(lines_with(outcome.out, "\rfinding solutions: 312 so far, ") > 0);
    CHECK(lines_with(outcome.out, "\r\x1b[Kproblem     2*Pa/Pa/Pa + P/P/P") == 1);
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
    const auto not_certified = [&] {
        return lines_with(read_file(folder / "1" / "degrees.csv"), ",0\n");
    };
    const std::size_t classes = not_certified();
    CHECK(classes > 5);
    const Outcome collected =
        run(in_folder + plcheck + " --json 1/degrees.plc >report && " + plprove +
            " collect --checked report -o 1 && " + plcheck + " 1/degrees.plc");
    CHECK(collected.status == 0);
    const std::size_t records = lines_with(read_file(folder / "1" / "degrees.plc"), "\ndegree ");
    CHECK(records > 5);
    CHECK(not_certified() == classes - records);
}
