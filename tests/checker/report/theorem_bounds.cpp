// Upper bounds by theorem: they need no file, they are applied to classes proved minimal in the
// same run only, and they are called what they are.
#include "checker/bounds/theorems.h"
#include "checker/degrees/constraint_class.h"
#include "prover/classification/problem_certificate.h"
#include "prover/problem/notation.h"
#include "tests/support/results.h"

#include <set>

using namespace checker;

namespace {

constexpr std::size_t chicago = 2394; // 2*Pa/Pa/Pa + P/P/P
constexpr std::size_t chicago_degree = 312;

const std::string empty_bounds = "plcert 2 bounds\nmodulus 2305843009213693951\n";

/// A degree file that proves so many solutions of one class.
ReplayedFile at_least(std::size_t number, std::size_t solutions, bool complete = false) {
    return degree_file({{number, solutions, complete}});
}

/// The exact degrees of a report, by class.
std::map<std::size_t, std::size_t> exact(const Report& report) {
    std::map<std::size_t, std::size_t> degrees;
    for (const auto& [number, degree, by_theorem, problem] : report.exact)
        degrees[number] = degree;
    return degrees;
}

const paper::DegreeClaim& line_on_class(const Report& report, std::size_t number) {
    for (const paper::DegreeClaim& claim : report.degrees)
        if (claim.claim.find(say("class ", number, ":")) != std::string::npos) return claim;
    FAIL(number);
    return report.degrees.front();
}

} // namespace

TEST_CASE("a file without templates certifies no bound") {
    const ReplayedFile empty = replay(all_classes(), "bounds.plc", empty_bounds);
    REQUIRE(std::holds_alternative<BoundsFile>(empty.content));
    CHECK(std::get<BoundsFile>(empty.content).bounds.empty());
    for (const auto& files : {std::vector{empty}, std::vector{whole_classification(), empty},
                              std::vector{problem_of_class(chicago), empty}}) {
        const Report report = summarize(all_classes(), files);
        CHECK(report.status == 1); // it proves nothing
        CHECK(report.upper_bounds.empty());
        CHECK(report.exact.empty());
        CHECK(report.degrees.empty());
        CHECK(detailed(report).find("at most ") ==
              detailed(report).find("at most one pin a point"));
        CHECK(detailed(report).find("solutions") == std::string::npos);
    }
    CHECK(finding(empty) == "bounds.plc: 0 templates hold, 0 refused\n");
}

TEST_CASE("no bound by theorem is applied to a class that is not proved minimal in this run") {
    const std::vector<std::vector<ReplayedFile>> runs{
        {at_least(chicago, chicago_degree)},
        {at_least(chicago, chicago_degree), bounds_file({{relative_pose, 20}})},
        {at_least(chicago, chicago_degree), problem_of_class(6722)},
        {at_least(chicago, chicago_degree, true)}};
    for (const auto& files : runs) {
        const Report report = summarize(all_classes(), files);
        CHECK(report.status == 0);
        CHECK_FALSE(exact(report).contains(chicago));
    }
    Verdicts others = all_verdicts();
    others[chicago].reset();
    const Report without =
        summarize(all_classes(), {classification_with(others), at_least(chicago, chicago_degree)});
    CHECK_FALSE(exact(without).contains(chicago));
    // More solutions than the theorem allows are no contradiction, if the class is not known to
    // meet what it assumes.
    CHECK(summarize(all_classes(), {at_least(chicago, 1000)}).status == 0);
    const Report alone = summarize(all_classes(), runs[0]);
    CHECK(alone.degrees.empty());
    CHECK(summary(alone).ends_with("exactly   no degree: upper bounds are for classes certified "
                                   "minimal; add classification.plc\n"));
}

TEST_CASE("a problem file of the class is enough: 2*Pa/Pa/Pa + P/P/P has exactly 312 solutions") {
    const std::string certificate =
        plprove::write(plprove::certify_problem(plprove::parse_problem("2*Pa/Pa/Pa + P/P/P")));
    const ReplayedFile problem = replay(all_classes(), "problem.plc", certificate);
    const Report report = summarize(all_classes(), {problem, at_least(chicago, chicago_degree)});
    CHECK(report.status == 0);
    CHECK(exact(report) == std::map<std::size_t, std::size_t>{{chicago, chicago_degree}});
    const paper::DegreeClaim& line = line_on_class(report, chicago);
    CHECK(line.at_least == "312");
    CHECK(line.exact == "312");
    CHECK(line.by_theorem == "312");
    CHECK(line.known == "312");
    CHECK(report.upper_bounds.empty()); // these are counted where there is a file of bounds
}

TEST_CASE("one solution less leaves the degree open, or known by evidence") {
    for (const bool complete : {false, true}) {
        const Report report =
            summarize(all_classes(),
                      {whole_classification(), at_least(chicago, chicago_degree - 1, complete)});
        CHECK_FALSE(exact(report).contains(chicago));
        const paper::DegreeClaim& line = line_on_class(report, chicago);
        CHECK(line.at_least == "311");
        CHECK(line.exact == "-");
        CHECK(line.by_theorem == "-");
        CHECK(line.known == (complete ? "311" : "-"));
    }
}

TEST_CASE("with the classification all classes of a constraint class are exact") {
    const Report report = summarize(all_classes(), {whole_classification(), at_least(2447, 376)});
    CHECK(exact(report) == std::map<std::size_t, std::size_t>{{2447, 376}, {2448, 376}});
    for (const paper::DegreeClaim& claim : report.degrees)
        if (claim.claim == "terminal, of any degree") {
            CHECK(claim.exact == claim.by_theorem);
            CHECK(claim.exact != "0");
        }
}

TEST_CASE("the problems of Theorem U8 have the same degree: one that is attained is so for all") {
    const Report report = summarize(all_classes(), {whole_classification(), at_least(4, 64)});
    std::size_t equal = 0;
    for (const TheoremBound& row : theorem_bounds)
        equal += row.theorem == theorem_of_equal_degrees;
    CHECK(equal == 7);
    std::set<Signature> found;
    for (const auto& [number, degree, by_theorem, problem] : report.exact) {
        CHECK(degree == 64);
        found.insert(constraint_class(all_classes().representatives[number]));
    }
    CHECK(found.size() == equal);
    // Other theorems say so of no other class.
    CHECK(exact(summarize(all_classes(), {whole_classification(), at_least(811, 224)})) ==
          std::map<std::size_t, std::size_t>{{811, 224}});
}

TEST_CASE("where a theorem and a degree file contradict each other, nothing follows of degrees") {
    const Report report =
        summarize(all_classes(), {whole_classification(), at_least(chicago, chicago_degree + 1),
                                  bounds_file({{relative_pose, 20}})});
    CHECK(report.status == 1);
    CHECK(report.degrees.empty());
    CHECK(report.exact.empty());
    CHECK(report.upper_bounds.empty());
    const std::string reason = "bounds contradict each other: 2*Pa/Pa/Pa + P/P/P has at least 313 "
                               "solutions, and at most 312";
    CHECK(report.findings.comparisons[0].objections.empty());
    CHECK(report.findings.comparisons[1].objections == std::vector{reason});
    CHECK(report.findings.comparisons[2].objections == std::vector{reason});
    CHECK(complaints(report) ==
          say("degrees.plc:0: refused: ", reason, "\nbounds.plc:0: refused: ", reason, "\n"));
    CHECK(detailed(report).find("camera-degrees") == std::string::npos);
    // What the classification proves stays.
    for (const paper::Claim& claim : report.claims)
        CHECK(claim.verdict != "not covered by these files");
}
