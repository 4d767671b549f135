// What the prover writes, the checker accepts, for random problems of every kind: two programs that
// share no source agree on verdicts, numbers, ranks and minors.
#include "checker/replay.h"
#include "prover/minimal/problem_file.h"
#include "tests/support/all_classes.h"
#include "tests/support/random_problems.h"

using namespace plprove;

namespace {

/// Certifies and checks; returns the verdict's first word.
std::string agree(const Features& problem) {
    const ProblemFile certificate = certify_problem(problem);
    const std::string text = write(certificate);
    CAPTURE(text);
    const checker::ReplayedFile replayed = checker::replay(all_classes(), "test", text);
    const auto* file = std::get_if<checker::ProblemFile>(&replayed.content);
    REQUIRE(file);
    if (file->refusals.count > 0) CAPTURE(file->refusals.first.front().reason);
    CHECK(file->refusals.count == 0);
    CHECK(file->problem == notation(problem));
    std::string expected(name(certificate.decision.verdict));
    const int excess = certificate.decision.constraints - certificate.decision.camera_dimension;
    if (excess != 0) expected += " " + std::to_string(std::abs(excess));
    CHECK(file->verdict == expected);
    REQUIRE(file->of_class.has_value() == certificate.decision.classes.has_value());
    if (file->of_class) CHECK(file->of_class->number == certificate.decision.classes->label);
    return std::string(name(certificate.decision.verdict));
}

} // namespace

TEST_CASE("the checker accepts the certificates of random problems of every kind") {
    RandomProblems random(42);
    std::map<std::string, int> verdicts;
    for (int i = 0; i < 300; ++i)
        ++verdicts[agree(random.around_a_class(random.below(10)))];
    for (int i = 0; i < 200; ++i) {
        Features problem;
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
    REQUIRE(all_classes().representatives.size() == label_classes().size());
    for (std::size_t number = 0; number < label_classes().size(); ++number) {
        const Signature& signature = label_classes()[number];
        const checker::Signature& other = all_classes().representatives[number];
        const Obstruction ours = obstruction(problem_of(signature));
        const checker::Obstruction theirs = checker::obstruction(other);
        const bool same = std::ranges::equal(signature, other) &&
                          class_number(label_classes(), swap_representative(signature)) ==
                              all_classes().swap_class[number] &&
                          static_cast<unsigned>(ours.deficiency()) == theirs.deficiency();
        if (!same) FAIL(number);
    }
}

TEST_CASE("both programs write a problem in the same notation") {
    for (std::size_t number = 0; number < label_classes().size(); number += 997)
        CHECK(notation(problem_of(label_classes()[number])) ==
              checker::notation(all_classes().representatives[number]));
}
