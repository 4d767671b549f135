// Degrees by theorem: they need no file, they are given to classes proved minimal in the same run
// only, and they are called what they are.
#include "prover/minimal/problem_file.h"
#include "prover/problem/notation.h"
#include "tests/support/degree_claims.h"
#include "tests/support/minimal_classes.h"

#include "checker/conclusion/pages_of_theorems.h"
#include "checker/degrees/constraint_class.h"
#include "checker/problem/notation.h"

#include <filesystem>
#include <map>

using namespace checker;

namespace {
constexpr std::size_t chicago = 2394; // 2*Pa/Pa/Pa + P/P/P

using Exact = std::map<std::size_t, std::size_t>;

/// The exact degrees of a report, by class.
Exact exact(const Report& report) {
    Exact degrees;
    for (const ExactDegree& one : report.exact)
        degrees[one.number] = one.degree;
    return degrees;
}
} // namespace

TEST_CASE("no theorem is applied to a class that is not proved minimal in this run") {
    const ReplayedFile record = degree_file({{chicago, 312}});
    for (const auto& files : {std::vector{record}, std::vector{record, problem_of_class(6722)}}) {
        const Report report = summarize(all_classes(), files);
        CHECK(report.status == 0);
        CHECK_FALSE(exact(report).contains(chicago));
    }
    Verdicts others = all_verdicts();
    others[chicago].reset();
    CHECK(exact(summarize(all_classes(), {classification_with(others), record})).empty());
    const Report alone = summarize(all_classes(), {record});
    CHECK(alone.degrees.empty());
    CHECK(summary(alone).ends_with("exactly   no degree: theorems are for classes certified "
                                   "minimal; add classification.plc\n"));
}

TEST_CASE("theorems are asked of the classes that files bound, and of the one that is expected") {
    const ReplayedFile all = whole_classification();
    CHECK(exact(summarize(all_classes(), {all})).empty());
    CHECK(exact(summarize(all_classes(), {all, degree_file({{2447, 300}})})) ==
          Exact{{2447, 376}, {2448, 376}}); // the whole constraint class
    CHECK(exact(summarize(all_classes(), {problem_of_class(2447), degree_file({{2448, 1}})})) ==
          Exact{{2447, 376}}); // only this one is proved minimal
    const ExpectedProblem expected{.problem = parse_problem("2*Pa/Pa/Pa + P/P/P"),
                                   .degree = ExpectedDegree{true, 312}};
    CHECK(exact(summarize(all_classes(), {all}, expected)) == Exact{{chicago, 312}});
    const Report report = summarize(all_classes(), {problem_of_class(chicago)}, {}, true);
    CHECK(exact(report) == Exact{{chicago, 312}});
    CHECK(claim_on(report, "3002_1, class 2394").exact == "312");
}

TEST_CASE("a problem file of the class is enough: 2*Pa/Pa/Pa + P/P/P has exactly 312 solutions") {
    const std::string certificate =
        plprove::write(plprove::certify_problem(plprove::parse_features("2*Pa/Pa/Pa + P/P/P")));
    const ReplayedFile problem = replay(all_classes(), "problem.plc", certificate);
    const Report report = summarize(all_classes(), {problem}, {}, true);
    CHECK(report.status == 0);
    CHECK(exact(report) == Exact{{chicago, 312}});
}

TEST_CASE("where a theorem and a degree file contradict each other, nothing follows of degrees") {
    const Report report =
        summarize(all_classes(), {whole_classification(), degree_file({{chicago, 313}}),
                                  registration_file(relative_pose, 20)});
    CHECK(report.status == 1);
    CHECK(report.degrees.empty());
    CHECK(report.exact.empty());
    const std::string reason = "bounds contradict each other: class 2394 has at least 313 "
                               "solutions, and at most 312, by Theorem C of "
                               "proofs/three_views/4_classes.md";
    CHECK(report.findings.objections[0].empty());
    CHECK(report.findings.objections[1] == std::vector{reason});
    CHECK(report.findings.objections[2].empty()); // the model is not to blame
    CHECK(complaints(report) == say("degrees.plc:0: refused: ", reason, "\n"));
    CHECK(detailed(report).find("camera-degrees") == std::string::npos);
    // What the classification proves stays.
    for (const paper::Claim& claim : report.claims)
        CHECK(claim.verdict != paper::not_covered);
}

TEST_CASE("each theorem has a page that exists") {
    exactly::Degrees degrees;
    for (const char* problem :
         {"2*Pa/Pa/Pa + P/P/P", "Pabcd/Pabcd/Pabcd + 2*a/a/a", "Pabcdef/Pabcdef/Pabcdef + 2*P/a/a",
          "Pabcde/Pabcde/Pabcde + 2*-/P/P + P/a/a"}) {
        const auto degree =
            degrees.of(constraint_class(all_classes().representatives[class_of(problem)]));
        REQUIRE(degree);
        const std::string page = say(SOURCE_DIR, "/proofs/", page_of(degree->theorem));
        CAPTURE(page);
        CHECK(std::filesystem::is_regular_file(page));
    }
}
