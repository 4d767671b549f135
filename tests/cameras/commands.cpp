// A new kind of cameras is one file of the prover and one of the checker: the commands, linked with
// level.cpp of both, decide problems of such cameras, find their solutions and certify both.
#include "tests/support/program.h"
#include "tests/support/text.h"

#include <doctest/doctest.h>

namespace {

const std::string plprove = PLPROVE;
const std::string plcheck = PLCHECK;

} // namespace

TEST_CASE("plprove decides problems of a new kind, and plcheck replays its certificates") {
    const TemporaryFolder folder;
    const std::string file = (folder / "verdict.plc").string();
    const auto decide = [&](const std::string& problem) {
        const Outcome said = run(plprove + " problem '" + problem + "' --certificate " + file);
        REQUIRE(said.status == 0);
        CHECK(run(plcheck + ' ' + file).status == 0);
        return said.out;
    };
    const std::string minimal = decide("level: 3*P/P");
    CHECK(contains(minimal, "cameras     2 level\n"
                            "dimensions  scene 9 + cameras 3 = images 12: balanced\n"
                            "verdict     minimal\n"));
    CHECK(run(plcheck + " --expect 'level: 3*P/P' --verdict minimal " + file).status == 0);
    CHECK(contains(decide("level: 2*P/P/P + Pa/Pa/Pa"), "verdict     unbalanced"));
    // Two points in three views: turning all cameras about the axis through a point, the vertical
    // one, is a motion of space.
    CHECK(contains(decide("level: 2*Pa/Pa/Pa + a/a/a"), "verdict     unbalanced"));
    const std::string over = decide("level: 3*P/P/P/- + P/-/P/P + a/a/a/a");
    CHECK(!over.empty());
}

TEST_CASE("plprove finds the four solutions of three points in two level views") {
    const TemporaryFolder folder;
    const std::string verdict = (folder / "verdict.plc").string();
    const std::string solutions = (folder / "solutions.plc").string();
    REQUIRE(run(plprove + " certify 'level: 3*P/P' -o " + verdict).status == 0);
    const Outcome found = run(plprove + " degree 'level: 3*P/P' -o " + solutions);
    CHECK(found.status == 0);
    CHECK(contains(found.out, "\ndegree      4 by evidence\n"));
    CHECK(contains(found.out, "\ncertificate of at least 4 solutions"));
    const Outcome checked =
        run(plcheck + " --expect 'level: 3*P/P' --degree '>=4' " + verdict + ' ' + solutions);
    CHECK(checked.status == 0);
}
