// Problem files by the letter of FORMAT.md, section 7: which spellings, steps, verdicts and
// evidence the checker takes, and which it refuses although they come close.
#include "checker/report.h"

#include <doctest/doctest.h>

using namespace checker;

namespace {

/// What the checker makes of a problem file without its first line: `holds`, or the first complaint
/// as `line: reason`.
std::string outcome(const std::string& rest) {
    static const Classification classes = classify();
    const FileReport report = replay(classes, "file", "plcert 1 problem\n" + rest);
    if (report.complaints.empty()) return "holds";
    const auto& [line, reason] = report.complaints[0];
    return say(report.conforms ? "" : "syntax, ", line, ": ", reason);
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != text.npos;
}

/// Whether the step is allowed on the only feature of a problem.
bool allowed(const std::string& feature, const std::string& rule, const std::string& result) {
    const std::string found =
        outcome(say("problem ", feature, "\nreduce 1 ", rule, ' ', result, "\nverdict minimal\n"));
    CAPTURE(found);
    CHECK(!found.starts_with("syntax"));
    return !contains(found, "this is no rule for");
}

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

std::string with(std::string text, const std::string& old, const std::string& replacement) {
    REQUIRE(contains(text, old));
    return text.replace(text.find(old), old.size(), replacement);
}

} // namespace

TEST_CASE("a feature has one spelling, a problem as many views as its features") {
    for (const char* problem :
         {"Pa/Pa/Pa", "P/P", "P/P/P(a)", "-/-/-(P)", "-/-/-(a)", "a/a/a(P)", "a/b/-", "-/-/-(ab)",
          "2*P/P/P", "1000*P/P/P", "P/P/P + a/a/a + P/P/P", "Pab/b/a + Pab/a/b"}) {
        CAPTURE(problem);
        CHECK(!outcome(say("problem ", problem, "\nverdict x\n")).starts_with("syntax"));
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
        CHECK(outcome(say("problem ", problem, "\nverdict x\n")).starts_with("syntax, 2: "));
    }
    CHECK(outcome("problem P/P/P + Pa/-/-\nreduce 2 pin-seen-once P/-\n").starts_with("syntax, 3"));
}

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
        CHECK(contains(outcome(say("problem ", feature, "\nverdict minimal\n")),
                       "a rule still applies to"));
    }
}

TEST_CASE("the verdict is a count of dimensions, or has the evidence that it needs") {
    CHECK(outcome("problem 3*P/P/P\nverdict under-constrained 2\n") == "holds");
    CHECK(outcome("problem 6*P/P\nverdict over-constrained 1\n") == "holds");
    for (const char* wrong : {"under-constrained 1", "under-constrained 3", "over-constrained 2",
                              "under-constrained", "minimal", "camera-minimal", "obstructed",
                              "under-constrained 2 2", "under-constrained 02"}) {
        CAPTURE(wrong);
        CHECK(contains(outcome(say("problem 3*P/P/P\nverdict ", wrong, '\n')), "3: "));
    }
    CHECK(outcome(five_points) == "holds");
    CHECK(outcome("problem 3*P/P/P\nverdict under-constrained 2\n" +
                  five_points.substr(five_points.find("modulus")))
              .starts_with("syntax, 4: "));
    CHECK(outcome(five_points.substr(0, five_points.find("modulus"))) != "holds");
}

TEST_CASE("the evidence of a problem in two views is refused if anything in it is altered") {
    CHECK(outcome(with(five_points, "3\nfeature",
                       "3\ncamera 3 quaternion 1 0 0 0 translation 1 0 0"
                       "\nfeature")) != "holds");
    CHECK(outcome(with(five_points, "verdict minimal", "verdict camera-minimal")) != "holds");
    CHECK(outcome(with(five_points, "minimal - 1", "minimal 0 1")) != "holds");
    CHECK(outcome(with(five_points, "minimal - 1", "minimal - 2")) != "holds");
    CHECK(outcome(with(five_points, "760\n", "761\n")) != "holds");
    CHECK(outcome(with(five_points, "951", "950")) != "holds");
    CHECK(outcome(with(five_points, "pool 1", "pool 2")) != "holds");
    CHECK(outcome(with(five_points, "feature P/P point 3 2 3\n", "")) != "holds");
    CHECK(outcome(with(five_points, "minimal -", "feature P/P point 1 2 3\nminimal -")) != "holds");
    CHECK(outcome(with(five_points, "feature P/P point 0", "feature P/- point 0")) != "holds");
    CHECK(outcome(five_points + "minimal - 1 48372612341760\n").starts_with("syntax, 13: "));
    CHECK(outcome(five_points + "# a comment\n") == "holds");
}

TEST_CASE(
    "of a camera-minimal problem, as many own columns of J are deleted as there are too many") {
    const std::string open = R"(problem 3*P/P/P + P/P/a
verdict camera-minimal
modulus 2305843009213693951
pool 1
camera 2 quaternion 0 0 1 0 translation 3 -2 -3
camera 3 quaternion 1 0 -1 -1 translation -3 -1 -3
feature P/P/P point 0 3 1
feature P/P/P point -2 1 -1
feature P/P/P point 0 2 -2
feature P/P/a point 2 -2 3 pin 0 -3 -1
camera-minimal 6723 1
delete columns 14
minor 988780599077191710
)";
    CHECK(outcome(open) == "holds");
    CHECK(contains(outcome(with(open, "columns 14", "columns 13")), "the minor is"));
    CHECK(contains(outcome(with(open, "columns 14", "columns 15")), "own columns"));
    CHECK(contains(outcome(with(open, "columns 14", "columns 25")), "own columns"));
    CHECK(contains(outcome(with(open, "columns 14", "columns 13 14")), "deleted columns"));
    CHECK(contains(outcome(with(open, "columns 14", "columns 1 2 3 14")), "deleted columns"));
    CHECK(outcome(with(open, "columns 14", "columns 14 13")).starts_with("syntax, 13: "));
    CHECK(outcome(with(open, "delete columns 14\n", "")).starts_with("syntax, 13: "));
    CHECK(contains(outcome(with(open, "6723", "6722")), "the number of the class is 6723"));
}

TEST_CASE("deleted columns of features that need them leave a minor of 0") {
    const std::string file = R"(problem 3*P/P/P + a/a/a + 5*a/-/-
reduce 5 free-line nothing
reduce 5 free-line nothing
reduce 5 free-line nothing
reduce 5 free-line nothing
reduce 5 free-line nothing
verdict camera-minimal
modulus 2305843009213693951
pool 1
camera 2 quaternion 0 0 1 0 translation 3 -2 -3
camera 3 quaternion 1 0 -1 -1 translation -3 -1 -3
feature P/P/P point 0 3 1
feature P/P/P point -2 1 -1
feature P/P/P point 0 2 -2
feature a/a/a point 2 -2 3 pin 0 -3 -1
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
    CHECK(outcome(file) == "holds");
    // The points put up to 18 conditions on the 11 camera coordinates; the lines are short of rows.
    for (const char* others : {"1 2 3 4 5 6 7 8 9 10", "1 2 3 4 5 6 7 8 31 33",
                               "1 2 3 17 18 20 25 27 29 33", "9 15 18 20 23 25 27 29 31 33"}) {
        CAPTURE(others);
        CHECK(contains(outcome(with(file, columns, others)), "the minor is 0 modulo q"));
    }
}
