// What the prover writes, the checker accepts, for random problems of every kind: two programs that
// share no source agree on verdicts, numbers, ranks and minors.
#include "checker/report.h"
#include "prover/classification/problem_certificate.h"
#include "tests/support/random_problems.h"

#include <doctest/doctest.h>
#include <map>

using namespace plprove;

namespace {

const checker::Classification& classes() {
    static const checker::Classification value = checker::classify();
    return value;
}

/// Certifies and checks; returns the verdict's first word.
std::string agree(const Problem& problem) {
    const ProblemCertificate certificate = certify_problem(problem);
    const std::string text = write(certificate);
    CAPTURE(text);
    const checker::FileReport report = checker::replay(classes(), "test", text);
    if (!report.complaints.empty()) CAPTURE(report.complaints.front().reason);
    CHECK(report.conforms);
    CHECK(report.refused == 0);
    std::string expected(name(certificate.decision.verdict));
    const int excess = certificate.decision.constraints - certificate.decision.camera_dimension;
    if (excess != 0) expected += " " + std::to_string(std::abs(excess));
    if (certificate.decision.classes)
        expected += ", class " + std::to_string(certificate.decision.classes->label);
    CHECK(report.certified == expected);
    return std::string(name(certificate.decision.verdict));
}

} // namespace

TEST_CASE("the checker accepts the certificates of random problems of every kind") {
    RandomProblems random(42);
    std::map<std::string, int> verdicts;
    for (int i = 0; i < 300; ++i)
        ++verdicts[agree(random.around_a_class(random.below(10)))];
    for (int i = 0; i < 200; ++i) {
        Problem problem;
        const int views = 2 + random.below(2);
        for (int size = 1 + random.below(views == 2 ? 9 : 7); size > 0; --size)
            problem.push_back(random.feature(views, 9));
        ++verdicts[agree(problem)];
    }
    for (const char* verdict :
         {"minimal", "camera-minimal", "obstructed", "under-constrained", "over-constrained"})
        CHECK(verdicts[verdict] > 0);
}

TEST_CASE("both programs enumerate the same classes, swap classes and obstructions") {
    REQUIRE(classes().representatives.size() == label_classes().size());
    for (std::size_t number = 0; number < label_classes().size(); ++number) {
        const Signature& signature = label_classes()[number];
        const checker::Signature& other = classes().representatives[number];
        const Obstruction ours = obstruction(problem_of(signature));
        const checker::Obstruction theirs = checker::obstruction(other);
        const bool same = std::ranges::equal(signature, other) &&
                          class_number(label_classes(), swap_representative(signature)) ==
                              classes().swap_class[number] &&
                          static_cast<unsigned>(ours.deficiency()) == theirs.deficiency();
        if (!same) FAIL(number);
    }
}

TEST_CASE("both programs write a problem in the same notation") {
    for (std::size_t number = 0; number < label_classes().size(); number += 997)
        CHECK(notation(problem_of(label_classes()[number])) ==
              checker::notation(classes().representatives[number]));
}
