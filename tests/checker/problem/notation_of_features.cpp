// Problems are spelled as section 1 of FORMAT.md says, in one way.
#include "tests/support/problem_outcome.h"

using namespace checker;

TEST_CASE("a feature has one spelling, and all features of a problem the same views") {
    for (const char* problem :
         {"Pa/Pa/Pa", "P/P", "P/P/P(a)", "-/-/-(P)", "-/-/-(a)", "a/a/a(P)", "a/b/-", "-/-/-(ab)",
          "2*P/P/P", "1000*P/P/P", "P/P/P + a/a/a + P/P/P", "Pab/b/a + Pab/a/b"}) {
        CAPTURE(problem);
        CHECK(!outcome_of_problem(say("problem ", problem, "\nverdict x\n")).starts_with("syntax"));
    }
    for (const char* problem : {"P",
                                "P/P/P/P",
                                "P/P + P/P/P",
                                "P/P/P + P/P",
                                "Pb/P/P",
                                "Pba/P/P",
                                "Paa/P/P",
                                "aP/P/P",
                                "ab/P/P",
                                "P/P/P(P)",
                                "a/b/-(P)",
                                "-/-/-",
                                "P/P/P()",
                                "P/P/P(a",
                                "P/P/Pa)",
                                "p/P/P",
                                "PP/P/P",
                                "/P/P",
                                "P//P",
                                "P/P/",
                                "-P/P/P",
                                "0*P/P/P",
                                "1*P/P/P",
                                "02*P/P/P",
                                "*P/P/P",
                                "1001*P/P/P",
                                "600*P/P/P + 600*a/a/a",
                                "P/P/P + P/P/P",
                                "2*P/P/P + P/P/P",
                                "P/P/P +",
                                "+ P/P/P",
                                "P/P/P+a/a/a",
                                "P/P/P a/a/a",
                                "2 * P/P/P",
                                "2*",
                                "a/a/a(Pa)",
                                "P/P/P(b)"}) {
        CAPTURE(problem);
        CHECK(outcome_of_problem(say("problem ", problem, "\nverdict x\n"))
                  .starts_with("syntax, 2: "));
    }
    CHECK(outcome_of_problem("problem P/P/P + Pa/-/-\nreduce 2 pin-seen-once P/-\n")
              .starts_with("syntax, 3"));
}
