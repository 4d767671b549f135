// The last line counts problems, classes and types, not records: whatever is proved twice, by other
// names, in one file or in several, counts once. And bounds that contradict each other are refused.
#include "checker/command/expected.h"
#include "tests/support/results.h"
#include "tests/support/text.h"

#include <nlohmann/json.hpp>

using namespace checker;

namespace {

/// Two spellings of one problem, in the family plmp, and another problem.
const std::string one = "3*PL/PL + 2*P/P", same = "P/P + PM/PM + P/P + 2*PM/PM";
const std::string other = "5*P/P";
const std::string eight = "projective: 7*P/P";

ReplayedFile verdicts(const std::vector<std::string>& notations) {
    ProblemsFile file;
    for (const std::string& notation : notations)
        file.verdicts.push_back({notation, parse_problem(notation), true});
    return {.name = "problems.plc", .content = file};
}

/// A file of solutions with this number of each problem.
ReplayedFile counts(const std::vector<std::pair<std::string, std::size_t>>& records) {
    SolutionsFile file;
    for (const auto& [notation, solutions] : records)
        file.counts.push_back({notation, parse_problem(notation), solutions});
    return {.name = "solutions.plc", .content = file};
}

/// A file of upper bounds.
ReplayedFile bounds(const std::vector<std::pair<std::string, std::size_t>>& records) {
    AtMostFile file;
    for (const auto& [notation, at_most] : records)
        file.bounds.push_back({notation, parse_problem(notation), at_most});
    return {.name = "at-most.plc", .content = file};
}

/// The last line up to the names of the files. The JSON report says the same.
std::string statement(const std::vector<ReplayedFile>& files) {
    const Report report = summarize(all_classes(), files);
    const std::string line = conclusion(report);
    const std::string text = line.substr(0, line.rfind(" ("));
    const auto told = nlohmann::json::parse(json(report)).at("conclusion").at("statement");
    CHECK((report.status == 0 ? "VERIFIED: " : "NOT VERIFIED: ") + told.get<std::string>() == text);
    return text;
}

} // namespace

TEST_CASE("a problem counts once, however many records are about it") {
    CHECK(statement({verdicts({one, same, one})}) == "VERIFIED: " + one + " is minimal");
    CHECK(statement({verdicts({one}), verdicts({same})}) == "VERIFIED: " + same + " is minimal");
    CHECK(statement({verdicts({one, other, same, other})}) ==
          "VERIFIED: the verdicts on 2 problems");
}

TEST_CASE("a problem file and a file of problems about the same problem count once") {
    const std::string chicago = "2*Pa/Pa/Pa + P/P/P";
    const ReplayedFile file = problem_of_class(2394);
    CHECK(statement({file, file}) == "VERIFIED: " + chicago + " is minimal");
    CHECK(statement({file, verdicts({"P/P/P + 2*Pa/Pa/Pa"})}) ==
          "VERIFIED: P/P/P + 2*Pa/Pa/Pa is minimal");
    CHECK(statement({file, problem_of_class(4)}) == "VERIFIED: the verdicts on 2 problems");
    CHECK(statement({file, verdicts({one})}) == "VERIFIED: the verdicts on 2 problems");
}

TEST_CASE("a family counts once") {
    ReplayedFile family = verdicts({one, other});
    std::get<ProblemsFile>(family.content).family = "plmp";
    CHECK(statement({family, family}) == "VERIFIED: all 2 problems of the family plmp, 2 minimal");
}

TEST_CASE("a class with solutions counts once, with the most that a record proves") {
    const ReplayedFile few = degree_file({{2394, 5}}), more = degree_file({{2394, 8}});
    CHECK(statement({few, more}) == "VERIFIED: at least 8 solutions of class 2394");
    CHECK(statement({more, few}) == "VERIFIED: at least 8 solutions of class 2394");
    CHECK(statement({few, degree_file({{4, 1}, {2394, 5}})}) ==
          "VERIFIED: lower bounds of the degrees of 2 classes");
}

TEST_CASE("a problem with solutions counts once, with the most that a record proves") {
    CHECK(statement({counts({{one, 4}, {same, 8}, {one, 3}})}) ==
          "VERIFIED: at least 8 solutions of " + same);
    CHECK(statement({counts({{one, 4}}), counts({{same, 4}})}) ==
          "VERIFIED: at least 4 solutions of " + one);
    CHECK(statement({counts({{one, 2}, {other, 2}, {same, 2}})}) ==
          "VERIFIED: lower bounds of the degrees of 2 problems in general");
}

TEST_CASE("a problem with an upper bound counts once, with the least that a record proves") {
    const std::string points = "projective: 6*P/P/P";
    CHECK(statement({bounds({{points, 4}, {points, 3}}), bounds({{points, 5}})}) ==
          "VERIFIED: at most 3 solutions of " + points + ", if it is minimal");
    CHECK(statement({bounds({{points, 4}, {eight, 3}, {points, 4}})}) ==
          "VERIFIED: upper bounds of the degrees of 2 problems in general");
}

TEST_CASE("a model counts once, with the least that a file proves") {
    const ReplayedFile poses = registration_file(relative_pose, 20);
    CHECK(statement({poses, registration_file(relative_pose, 21)}) ==
          "VERIFIED: registration_s_l0_i0_r5 has at most 20 solutions");
    CHECK(statement({poses, registration_file({.lines = 3}, 8)}) ==
          "VERIFIED: what 2 models have of solutions");
}

TEST_CASE("more solutions than a theorem allows of a problem in general are refused") {
    const std::string refused = "NOT VERIFIED: 1 of 1 file is refused";
    CHECK(statement({counts({{eight, 3}})}) == "VERIFIED: at least 3 solutions of " + eight);
    CHECK(statement({counts({{eight, 4}})}) == refused);
    const Report report = summarize(all_classes(), {counts({{other, 20}, {eight, 4}})});
    REQUIRE(report.findings.objections[0].size() == 1);
    CHECK(contains(report.findings.objections[0][0], "bounds contradict each other: " + eight +
                                                         " has at least 4 solutions, and at most "
                                                         "3, by Theorem "));
}

TEST_CASE("more solutions than a record allows of a problem in general are refused, and so is this "
          "record") {
    const std::string pins = "projective: 3*PLab/PLab/PLab + Pa/Pa/Pa";
    const std::string renamed = "projective: Pa/Pa/Pa + 3*PXab/PXab/PXab";
    CHECK(summarize(all_classes(), {counts({{pins, 6}}), bounds({{renamed, 6}})}).status == 0);
    const Report report =
        summarize(all_classes(), {counts({{pins, 7}}), bounds({{renamed, 6}}), verdicts({other})});
    CHECK(report.status == 1);
    CHECK(report.findings.objections[0].size() == 1);
    CHECK(report.findings.objections[1].size() == 1);
    CHECK(report.findings.objections[2].empty());
    CHECK(contains(complaints(report), "bounds contradict each other: " + pins +
                                           " has at least 7 solutions, and at most 6, "));
}

TEST_CASE("an expected degree is not verified by bounds that contradict each other") {
    const auto verified = [](std::size_t solutions) {
        const std::string degree = say(">=", solutions);
        return summarize(all_classes(), {counts({{eight, solutions}})},
                         expectation_of({.problem = eight, .degree = degree}))
            .judgement.verified;
    };
    CHECK(verified(3));
    CHECK(!verified(4));
}
