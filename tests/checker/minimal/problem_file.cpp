// Verdicts and proofs in problem files, by the letter of FORMAT.md, section 7: which the checker
// takes, and which it refuses although they come close.
#include "tests/support/problem_outcome.h"

using namespace checker;

namespace {

/// Five points in two views; a minimal problem in the coordinates of `plprove certify 5*P/P`.
const std::string five_points = R"(problem 5*P/P
verdict minimal
modulus 2305843009213693951
pool 1
camera 2 quaternion 0 -1 0 -1 translation 2 -1 -3
feature P/P point 0 -2 1
feature P/P point -2 -1 -3
feature P/P point 3 0 1
feature P/P point 3 2 3
feature P/P point -2 -3 3
minimal - 1 48372612341760
)";

/// How a pool of three views begins, with three points.
const std::string of_three_points = R"(modulus 2305843009213693951
pool 1
camera 2 quaternion 0 0 1 0 translation 3 -2 -3
camera 3 quaternion 1 0 -1 -1 translation -3 -1 -3
feature P/P/P point 0 3 1
feature P/P/P point -2 1 -1
feature P/P/P point 0 2 -2
)";

} // namespace

TEST_CASE("the verdict is a count of dimensions, or has the proof that it needs") {
    CHECK(outcome_of_problem("problem 3*P/P/P\nverdict under-constrained 2\n") == "holds");
    CHECK(outcome_of_problem("problem 6*P/P\nverdict over-constrained 1\n") == "holds");
    for (const char* wrong : {"under-constrained 1", "under-constrained 3", "over-constrained 2",
                              "under-constrained", "minimal", "camera-minimal", "obstructed",
                              "under-constrained 2 2", "under-constrained 02"}) {
        CAPTURE(wrong);
        CHECK(contains(outcome_of_problem(say("problem 3*P/P/P\nverdict ", wrong, '\n')), "3: "));
    }
    CHECK(outcome_of_problem(five_points) == "holds");
    CHECK(outcome_of_problem("problem 3*P/P/P\nverdict under-constrained 2\n" +
                             five_points.substr(five_points.find("modulus")))
              .starts_with("syntax, 4: "));
    CHECK(outcome_of_problem(five_points.substr(0, five_points.find("modulus"))) != "holds");
}

TEST_CASE("the proof of a problem in two views is refused if anything in it is altered") {
    CHECK(outcome_of_problem(with(five_points, "3\nfeature",
                                  "3\ncamera 3 quaternion 1 0 0 0 translation 1 0 0"
                                  "\nfeature")) != "holds");
    const std::string last = "feature P/P point -2 -3 3\n";
    CHECK(contains(outcome_of_problem(with(five_points, last, "")),
                   "the pool lacks the feature P/P"));
    CHECK(contains(outcome_of_problem(with(five_points, last, last + last)),
                   "the problem has no more features"));
    CHECK(outcome_of_problem(with(five_points, "verdict minimal", "verdict camera-minimal")) !=
          "holds");
    CHECK(outcome_of_problem(with(five_points, "minimal - 1", "minimal 0 1")) != "holds");
    CHECK(outcome_of_problem(with(five_points, "minimal - 1", "minimal - 2")) != "holds");
    CHECK(outcome_of_problem(with(five_points, "760\n", "761\n")) != "holds");
    CHECK(outcome_of_problem(with(five_points, "951", "950")) != "holds");
    CHECK(outcome_of_problem(with(five_points, "pool 1", "pool 2")) != "holds");
    CHECK(outcome_of_problem(with(five_points, "feature P/P point 3 2 3\n", "")) != "holds");
    CHECK(outcome_of_problem(
              with(five_points, "minimal -", "feature P/P point 1 2 3\nminimal -")) != "holds");
    CHECK(outcome_of_problem(with(five_points, "feature P/P point 0", "feature P/- point 0")) !=
          "holds");
    CHECK(outcome_of_problem(five_points + "minimal - 1 48372612341760\n")
              .starts_with("syntax, 13: "));
    CHECK(outcome_of_problem(with(five_points, "minimal -", "camera-minimal -")) ==
          "12: the proof must be minimal");
    CHECK(outcome_of_problem(five_points + "# a comment\n") == "holds");
}

TEST_CASE("of a camera-minimal problem, just the own columns that make J square are deleted") {
    const std::string open = R"(problem 3*P/P/P + P/P/a
verdict camera-minimal
)" + of_three_points + R"(feature P/P/a point 2 -2 3 pin 0 -3 -1
camera-minimal 6723 1
delete columns 14
minor 988780599077191710
)";
    CHECK(outcome_of_problem(open) == "holds");
    CHECK(contains(outcome_of_problem(with(open, "columns 14", "columns 13")), "the minor is"));
    CHECK(contains(outcome_of_problem(with(open, "columns 14", "columns 15")), "own columns"));
    CHECK(contains(outcome_of_problem(with(open, "columns 14", "columns 25")), "own columns"));
    CHECK(
        contains(outcome_of_problem(with(open, "columns 14", "columns 13 14")), "deleted columns"));
    CHECK(contains(outcome_of_problem(with(open, "columns 14", "columns 1 2 3 14")),
                   "deleted columns"));
    CHECK(
        outcome_of_problem(with(open, "columns 14", "columns 14 13")).starts_with("syntax, 13: "));
    CHECK(outcome_of_problem(with(open, "delete columns 14\n", "")).starts_with("syntax, 13: "));
    CHECK(contains(outcome_of_problem(with(open, "6723", "6722")),
                   "the number of the class is 6723"));
}

TEST_CASE("deleted columns of features that need them leave a minor of 0") {
    const std::string file = R"(problem 3*P/P/P + a/a/a + 5*a/-/-
reduce 5 free-line nothing
reduce 5 free-line nothing
reduce 5 free-line nothing
reduce 5 free-line nothing
reduce 5 free-line nothing
verdict camera-minimal
)" + of_three_points + R"(feature a/a/a point 2 -2 3 pin 0 -3 -1
feature a/-/- point 3 3 0 pin 2 -2 3
feature a/-/- point 2 0 -1 pin 0 0 1
feature a/-/- point 0 2 0 pin 3 2 2
feature a/-/- point -1 -3 -1 pin -1 2 -1
feature a/-/- point -2 3 3 pin 1 -2 3
camera-minimal 6722 1
delete columns 15 17 18 20 23 25 27 29 31 33
minor 63803342879554118
)";
    const std::string columns = "15 17 18 20 23 25 27 29 31 33";
    CHECK(outcome_of_problem(file) == "holds");
    // The points put up to 18 conditions on the 11 camera coordinates; the lines are short of rows.
    for (const char* others : {"1 2 3 4 5 6 7 8 9 10", "1 2 3 4 5 6 7 8 31 33",
                               "1 2 3 17 18 20 25 27 29 33", "9 15 18 20 23 25 27 29 31 33"}) {
        CAPTURE(others);
        CHECK(contains(outcome_of_problem(with(file, columns, others)), "the minor is 0 modulo q"));
    }
}
