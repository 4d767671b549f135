// The notation of problems in general, by the letter of FORMAT.md, section 13.
#include "tests/checker/minimal/image_rank.h"
#include "tests/checker/minimal/outcome.h"

using namespace checker;

TEST_CASE("each way of spelling a feature conforms") {
    for (const char* notation : {"P/P",
                                 "P/P/P/P/P/P/P/P/P/P/P/P",
                                 "projective: 7*P/P",
                                 "100*P/P",
                                 "100*P/P + 100*a/a",
                                 "Pabc/Pc/-",
                                 "a/a/-",
                                 "P/P/P(a)",
                                 "-/-/-(P)",
                                 "-/-/-(a)",
                                 "a/a/a(P)",
                                 "a/b/-",
                                 "-/-(ab)",
                                 "-/-(Pa)",
                                 "Pb/Pb",
                                 "3*PL/PL/PL",
                                 "2*PL/L/PL",
                                 "P/-(L) + -/P(L)",
                                 "-/-(PL) + P/-(L)",
                                 "PAa/PAa + PA/PA",
                                 "PQ/PQ + PQR/PQR + PR/PR",
                                 "c/c/c"}) {
        CAPTURE(notation);
        CHECK(outcome_of_notation(notation) == "holds");
    }
}

TEST_CASE("what section 13 does not spell is refused with the file") {
    for (const char* notation : {"P",
                                 "P/P/P/P/P/P/P/P/P/P/P/P/P",
                                 "P/P + P/P/P",
                                 "P/",
                                 "/P",
                                 "PP/P",
                                 "p/p()",
                                 "P/P()",
                                 "P/P(",
                                 "P/P)",
                                 "P/P(a",
                                 "P/P(a)(b)",
                                 "P/P(a)b",
                                 "Pba/P",
                                 "Paa/P",
                                 "PaA/PaA + PA/PA",
                                 "ab/Pab",
                                 "ab/ab",
                                 "A/A",
                                 "A/A + 2*PA/PA",
                                 "PA/PA",
                                 "-/-",
                                 "P/P(P)",
                                 "a/b(P)",
                                 "-/-(Pab)",
                                 "a/-(a)",
                                 "P/P(ba)",
                                 "1*P/P",
                                 "02*P/P",
                                 "1001*P/P",
                                 "2*2*P/P",
                                 "*P/P",
                                 "101*P/P",
                                 "101*a/a",
                                 "P/P + P/P",
                                 "2*P/P + P/P",
                                 "P/P +",
                                 "+ P/P",
                                 "P/P P/P",
                                 "P/P + + P/P",
                                 "projective: ",
                                 "projective P/P",
                                 "calibrated: P/P",
                                 "P1/P",
                                 "\\",
                                 "P / P"}) {
        CAPTURE(notation);
        CHECK(outcome_of_notation(notation).starts_with("syntax, "));
    }
}

TEST_CASE("a capital letter is one line, in the same views of all its features") {
    CHECK(contains(outcome_of_notation("PL/PL + PL/P"), "a capital letter in the same views"));
    CHECK(contains(outcome_of_notation("PL/PL/L + PL/PL/P"), "a capital letter in the same views"));
    CHECK(contains(outcome_of_notation("PL/PL + P/P"), "in two features or more"));
    CHECK(contains(outcome_of_notation("L/L + 2*PL/PL"), "a line with one small letter"));
    CHECK(contains(outcome_of_notation("PLM/PLM + PLM/PLM"), "syntax"));
    CHECK(contains(outcome_of_notation("2*PLM/PLM"), "at most one point"));
    CHECK(contains(outcome_of_notation("2*PL/P"), "sees two points of a line to see the line"));
}

TEST_CASE("a point lies on at most one line with two earlier points") {
    // The third points of two lines meet in the last point, or come before it.
    CHECK(contains(outcome_of_notation("2*PL/PL + 2*PM/PM + PLM/PLM"),
                   "at most one line with two earlier points"));
    CHECK(outcome_of_notation("PLM/PLM + 2*PL/PL + 2*PM/PM") == "holds");
    CHECK(outcome_of_notation("PL/PL + PM/PM + PLM/PLM + PL/PL + PM/PM") == "holds");
}

TEST_CASE("points and lines are numbered in the order of the notation") {
    const Problem problem = problem_of("a/a/- + PMa/PMa/PMa + 2*PLb/PLb/PLb(c) + PLM/PLM/PLM");
    REQUIRE(problem.points.size() == 4);
    CHECK(problem.points[0].lines == Indices{1, 2});    // M, a
    CHECK(problem.points[1].lines == Indices{3, 4, 5}); // L, b, c
    CHECK(problem.points[2].lines == Indices{3, 6, 7});
    CHECK(problem.points[3].lines == Indices{3, 1});
    REQUIRE(problem.lines.size() == 8);
    CHECK(problem.lines[0].points.empty());
    CHECK(problem.lines[0].seen_by == 0b011U);
    CHECK(problem.lines[1].points == Indices{0, 3});
    CHECK(problem.lines[3].points == Indices{1, 2, 3});
    CHECK(problem.lines[5].seen_by == 0U);
    CHECK(!carrier(problem, 2));
    CHECK(carrier(problem, 3) == std::optional<std::size_t>(3));
}
