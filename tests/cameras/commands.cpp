// A new kind of cameras is one file of the prover and one of the checker: the commands, linked with
// zooming.cpp of both, decide problems of such cameras, find their solutions and certify both.
#include "tests/support/program.h"
#include "tests/support/text.h"

#include <doctest/doctest.h>

namespace {

const std::string plprove = PLPROVE;
const std::string plcheck = PLCHECK;

/// What plprove says of a problem, whose certificate plcheck has replayed.
std::string decided(const std::string& problem, const std::string& verdict) {
    const TemporaryFolder folder;
    const std::string file = (folder / "verdict.plc").string();
    const Outcome said = run(plprove + " problem '" + problem + "' --certificate " + file);
    CHECK(said.status == 0);
    const Outcome checked =
        run(plcheck + " --expect '" + problem + "' --verdict " + verdict + ' ' + file);
    CHECK_MESSAGE(checked.status == 0, checked.out, checked.err);
    return said.out;
}

/// How many solutions plprove finds; plcheck has certified as many.
void check_solutions(const std::string& problem, const std::string& count) {
    CAPTURE(problem);
    const TemporaryFolder folder;
    const std::string verdict = (folder / "verdict.plc").string();
    const std::string solutions = (folder / "solutions.plc").string();
    CHECK(run(plprove + " certify '" + problem + "' -o " + verdict).status == 0);
    const Outcome found = run(plprove + " degree '" + problem + "' -o " + solutions);
    CHECK(contains(found.out, "\ndegree      " + count + " by evidence\n"));
    const Outcome checked = run(plcheck + " --expect '" + problem + "' --degree '>=" + count +
                                "' " + verdict + ' ' + solutions);
    CHECK_MESSAGE(checked.status == 0, checked.out, checked.err);
}

} // namespace

TEST_CASE("plprove decides problems of a new kind, and plcheck replays its certificates") {
    CHECK(contains(decided("zooming: 3*P/P", "minimal"),
                   "cameras     2 zooming\n"
                   "dimensions  scene 9 + cameras 3 = images 12: balanced\n"
                   "verdict     minimal\n"));
    CHECK(contains(decided("zooming: 2*P/P/P", "not-minimal"), "scene 6 + cameras 7 against images "
                                                               "12: unbalanced\n"));
    // Of view 3 nothing but the first point and its pins: camera 3 may slide.
    CHECK(contains(decided("zooming: Pab/Pab/Pab + 2*P/P/-", "not-minimal"),
                   "looks the same when cameras slide along their rays to point 1"));
    CHECK(contains(decided("zooming: 4*P/P/- + 3*P/-/P", "not-minimal"),
                   "the part of points 1 2 3 4 and lines - in views 1 2 has fewer parameters"));
    CHECK(contains(decided("zooming: 2*P/P/- + 2*P/-/P + 3*-/P/P", "minimal"), "minimal"));
}

TEST_CASE("the solutions of problems of a new kind are found and certified") {
    if (contains(run(plcheck + " --version").out, "without Arb")) return;
    // A point x in view 1 and y in view 2: det(y, diag(r, r, 1) x, t) = 0. For three points this is a
    // determinant in r, quadratic but for a factor r, which is no camera.
    check_solutions("zooming: 3*P/P", "2");
    check_solutions("zooming: Pa/Pa/Pa + P/P/P", "1");
}
