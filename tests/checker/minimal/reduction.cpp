// Rules of reduction: each applies where the table of FORMAT.md, section 7, says.
#include "tests/support/problem_outcome.h"

using namespace checker;

namespace {

/// Whether the step is allowed on the only feature of a problem.
bool allowed(const std::string& feature, const std::string& rule, const std::string& result) {
    const std::string found = outcome_of_problem(
        say("problem ", feature, "\nreduce 1 ", rule, ' ', result, "\nverdict minimal\n"));
    CAPTURE(found);
    CHECK(!found.starts_with("syntax"));
    return !contains(found, "this is no rule for");
}

} // namespace

TEST_CASE("each rule applies where the table says, and to nothing that comes close") {
    CHECK(allowed("P/P/P(a)", "unseen-line", "P/P/P"));
    CHECK(allowed("-/-/-(a)", "unseen-line", "nothing"));
    CHECK(allowed("Pb/P/P(a)", "unseen-line", "Pa/P/P"));
    CHECK_FALSE(allowed("Pa/P/P", "unseen-line", "P/P/P"));
    CHECK_FALSE(allowed("a/-/-", "unseen-line", "nothing"));
    CHECK_FALSE(allowed("P/P/P(a)", "unseen-line", "nothing"));
    CHECK_FALSE(allowed("P/P/P(a)", "unseen-line", "P/P/-"));
    CHECK_FALSE(allowed("Pb/P/P(a)", "unseen-line", "P/P/P(a)"));

    CHECK(allowed("a/a/-", "free-line", "nothing"));
    CHECK(allowed("-/a/-", "free-line", "nothing"));
    CHECK(allowed("a/a", "free-line", "nothing"));
    CHECK_FALSE(allowed("a/a/a", "free-line", "nothing"));
    CHECK_FALSE(allowed("-/-/-(a)", "free-line", "nothing"));
    CHECK_FALSE(allowed("a/a/-(P)", "free-line", "nothing"));
    CHECK_FALSE(allowed("a/a/-", "free-line", "a/-/-"));

    CHECK(allowed("Pa/P/P", "pin-seen-once", "P/P/P"));
    CHECK(allowed("Pab/Pa/Pa", "pin-seen-once", "Pa/Pa/Pa"));
    CHECK_FALSE(allowed("P/P/a", "pin-seen-once", "P/P/-"));
    CHECK_FALSE(allowed("Pa/Pa/P", "pin-seen-once", "P/P/P"));
    CHECK_FALSE(allowed("Pab/Pa/Pa", "pin-seen-once", "Pa/P/P"));
    CHECK_FALSE(allowed("Pa/P/P", "pin-seen-once", "nothing"));
    CHECK_FALSE(allowed("a/-/-", "pin-seen-once", "nothing"));

    CHECK(allowed("Pa/Pa/P", "pin-seen-twice", "P/P/P"));
    CHECK(allowed("Pa/Pa", "pin-seen-twice", "P/P"));
    CHECK_FALSE(allowed("Pa/a/P", "pin-seen-twice", "P/-/P"));
    CHECK_FALSE(allowed("P/a/a", "pin-seen-twice", "P/-/-"));
    CHECK_FALSE(allowed("Pa/Pa/Pa", "pin-seen-twice", "P/P/P"));
    CHECK_FALSE(allowed("Pa/P/P", "pin-seen-twice", "P/P/P"));

    CHECK(allowed("a/a/a(P)", "unseen-point", "a/a/a"));
    CHECK(allowed("-/a/-(P)", "unseen-point", "-/a/-"));
    CHECK(allowed("a/b/-", "unseen-point", "nothing"));
    CHECK(allowed("a/b", "unseen-point", "nothing"));
    CHECK_FALSE(allowed("a/a/a(P)", "unseen-point", "nothing"));
    CHECK_FALSE(allowed("a/a/a(P)", "unseen-point", "a/a/a(P)"));
    CHECK_FALSE(allowed("a/a/a(P)", "unseen-point", "a/a/-"));
    CHECK_FALSE(allowed("a/b/-(c)", "unseen-point", "nothing"));
    CHECK_FALSE(allowed("-/-/-(Pa)", "unseen-point", "-/-/-(a)"));
    CHECK_FALSE(allowed("-/-/-(P)", "unseen-point", "nothing"));
    CHECK_FALSE(allowed("P/a/a", "unseen-point", "-/a/a"));
    CHECK_FALSE(allowed("P/a/b", "unseen-point", "nothing"));

    CHECK(allowed("P/-/-", "bare-point", "nothing"));
    CHECK(allowed("-/-/-(P)", "bare-point", "nothing"));
    CHECK(allowed("-/P", "bare-point", "nothing"));
    CHECK_FALSE(allowed("P/P/-", "bare-point", "nothing"));
    CHECK_FALSE(allowed("Pa/-/-", "bare-point", "nothing"));
    CHECK_FALSE(allowed("-/-/-(Pa)", "bare-point", "nothing"));
    CHECK_FALSE(allowed("P/-/-", "bare-point", "-/-/-(P)"));

    CHECK(allowed("Pa/a/a", "point-on-line", "a/a/a"));
    CHECK_FALSE(allowed("Pa/Pa/a", "point-on-line", "a/a/a"));
    CHECK_FALSE(allowed("a/a/a(P)", "point-on-line", "a/a/a"));
    CHECK_FALSE(allowed("P/a/a", "point-on-line", "-/a/a"));
    CHECK_FALSE(allowed("Pab/a/a", "point-on-line", "a/a/a"));
    CHECK_FALSE(allowed("Pa/a/a", "point-on-line", "nothing"));
    CHECK_FALSE(allowed("Pa/a/a", "point-on-line", "P/-/-"));
    CHECK_FALSE(allowed("Pa/a", "point-on-line", "a/a"));

    CHECK(allowed("P/a/-", "point-and-pin", "nothing"));
    CHECK(allowed("Pa/a/-", "point-and-pin", "nothing"));
    CHECK(allowed("-/a/Pa", "point-and-pin", "nothing"));
    for (const char* feature : {"P/a/a", "Pa/a/a", "Pa/P/a", "P/P/a", "Pa/-/-", "P/-/-", "P/a/b",
                                "Pb/a/-", "P/a/-(b)", "-/a/-(P)", "-/a/-", "Pab/b/a", "P/P/P"}) {
        CAPTURE(feature);
        CHECK_FALSE(allowed(feature, "point-and-pin", "nothing"));
    }
    CHECK_FALSE(allowed("P/a/-", "point-and-pin", "P/-/-"));
    CHECK(allowed("P/a", "point-and-pin", "nothing"));
    CHECK(allowed("Pa/a", "point-and-pin", "nothing"));
    for (const char* feature :
         {"P/P", "P/-", "Pa/Pa", "Pb/a", "Pab/a", "P/a(b)", "a/-(P)", "Pa/P", "a/b", "a/a"}) {
        CAPTURE(feature);
        CHECK_FALSE(allowed(feature, "point-and-pin", "nothing"));
    }
    CHECK_FALSE(allowed("P/-/-", "no-such-rule", "nothing"));
}

TEST_CASE("a problem to which a rule applies is not reduced") {
    for (const char* feature :
         {"P/P/P(a)", "-/-/-(a)", "a/a/-",  "-/a/-",     "Pa/P/P",
          "Pa/Pa/P",  "a/a/a(P)", "a/b/-",  "P/-/-",     "-/-/-(P)",
          "Pa/a/a",   "P/a/-",    "Pa/a/-", "Pab/Pa/Pa", "Pabcdefgh/Pabcdefgh/P",
          "Pa/a",     "P/a",      "a/a",    "P/-",       "Pa/Pa",
          "P/P(a)",   "Pa/P"}) {
        CAPTURE(feature);
        CHECK(contains(outcome_of_problem(say("problem ", feature, "\nverdict minimal\n")),
                       "a rule still applies to"));
    }
}
