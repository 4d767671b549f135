// Verdicts: laws, and ranks of whole Jacobians as a second method.
#include "prover/minimal/decision.h"
#include "prover/minimal/pool.h"
#include "prover/minimal/problem_file.h"
#include "prover/problem/spec.h"
#include "tests/support/random_problems.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <fstream>

using namespace plprove;

namespace {

/// The two ranks of a posed problem: of the whole Jacobian, and of the features' own columns.
struct Ranks {
    int rows = 0;
    int cameras = 0;
    int whole = 0;
    int own = 0;

    bool dominant() const { return whole == rows; }
    bool camera_finite() const { return whole - own == cameras; }
};

Ranks generic_ranks(const Features& problem, std::uint64_t seed) {
    SmallIntegers integers(seed, max_coordinate);
    const Cameras cameras = random_cameras(integers, problem.front().views());
    std::vector<FeatureBlock> blocks;
    for (const Feature& feature : problem)
        blocks.push_back(feature_block(random_placement(feature, cameras, integers), cameras));
    const ResidueMatrix whole = jacobian(pointers(blocks));
    const int own_columns = whole.columns() - blocks.front().cameras;
    ResidueMatrix own(whole.rows(), own_columns);
    for (int i = 0; i < own.rows(); ++i)
        for (int j = 0; j < own_columns; ++j)
            own.at(i, j) = whole.at(i, j);
    return {whole.rows(), blocks.front().cameras, static_cast<int>(nmod_mat_rank(whole.get())),
            static_cast<int>(nmod_mat_rank(own.get()))};
}

void check_against_ranks(const Features& problem) {
    CAPTURE(notation(problem));
    const Decision decision = decide(problem);
    const Ranks ranks = generic_ranks(problem, 1);
    const bool camera_minimal = ranks.dominant() && ranks.camera_finite();
    CHECK((decision.verdict == Verdict::minimal || decision.verdict == Verdict::camera_minimal) ==
          camera_minimal);
    CHECK((decision.verdict == Verdict::minimal) == (camera_minimal && decision.balanced()));
    if (decision.verdict == Verdict::under_constrained) CHECK_FALSE(ranks.camera_finite());
    if (decision.verdict == Verdict::over_constrained) CHECK_FALSE(ranks.dominant());
    if (decision.verdict == Verdict::obstructed) {
        CHECK_FALSE(ranks.dominant());
        CHECK_FALSE(ranks.camera_finite());
    }
}

} // namespace

TEST_CASE("verdicts agree with the committed archive for all 143,494 classes") {
    std::ifstream archive(CERTS_DIR "/classification.plc");
    std::size_t number = 0;
    for (std::string line; std::getline(archive, line);) {
        const bool minimal = line.starts_with("minimal ");
        if (!minimal && !line.starts_with("deficient ")) continue;
        const Verdict verdict = decide(problem_of(label_classes()[number])).verdict;
        if (verdict != (minimal ? Verdict::minimal : Verdict::obstructed)) FAIL(number);
        ++number;
    }
    CHECK(number == label_classes().size());
}

TEST_CASE("verdicts on random problems of every kind agree with the ranks of their Jacobians") {
    RandomProblems random(20200823);
    for (int i = 0; i < 400; ++i)
        check_against_ranks(random.around_a_class(random.below(12)));
    for (int i = 0; i < 300; ++i) {
        Features problem;
        const int views = 2 + random.below(2);
        for (int size = 1 + random.below(20); size > 0; --size)
            problem.push_back(random.feature(views, 9));
        check_against_ranks(problem);
    }
    for (const char* text :
         {"Pabcdefgh/Pabcdefgh/Pabcdefgh", "Pabcdefghi/Pabcdefghi/Pabcdefghi", "5*P/P",
          "5*P/P + Pa/a", "6*P/P/- + 5*P/-/P", "3*P/P/P + P/P/a", "3*P/P/P + P/a/b + P/a/a(b)"})
        check_against_ranks(parse_spec(text));
}

TEST_CASE("a verdict does not depend on names, on order, or on labels of views; nor on swaps") {
    RandomProblems random(7);
    for (int i = 0; i < 200; ++i) {
        const Features problem = random.around_a_class(random.below(5));
        const Decision decision = decide(problem);
        CAPTURE(notation(problem));
        const Decision disguised = decide(random.disguised(problem));
        CHECK(disguised.verdict == decision.verdict);
        CHECK(disguised.constraints == decision.constraints);
        CHECK(disguised.classes.has_value() == decision.classes.has_value());
        if (decision.classes) CHECK(disguised.classes->label == decision.classes->label);
        Features relabeled;
        const int order[] = {1, 2, 0};
        for (const Feature& feature : problem)
            relabeled.push_back(relabel_views(feature, order));
        CHECK(decide(relabeled).verdict == decision.verdict);
        Features swapped;
        for (const Feature& feature : problem)
            swapped.push_back(notation(feature) == "P/Pa/a" ? parse_feature("Pa/P/a") : feature);
        const Decision after = decide(swapped);
        CHECK(after.verdict == decision.verdict);
        if (decision.classes) CHECK(after.classes->swap == decision.classes->swap);
    }
}

TEST_CASE("the inverses of the reductions of Theorem 2 keep a minimal problem minimal") {
    RandomProblems random(11);
    for (int i = 0; i < 100; ++i) {
        Features problem =
            problem_of(label_classes()[static_cast<std::size_t>(random.below(143494))]);
        const Verdict verdict = decide(problem).verdict;
        for (Feature& feature : problem) {
            if (!feature.has_point) {
                // A point on the line, seen in one view.
                if (feature == parse_feature("a/a/a")) feature = parse_feature("Pa/a/a");
                continue;
            }
            // A pin more, seen by the first two views that see the point.
            if (std::ranges::count_if(feature.sights, &Sight::point) < 2) continue;
            int seen = 0;
            for (Sight& sight : feature.sights)
                if (sight.point && seen++ < 2) sight.pins |= 1U << feature.lines;
            ++feature.lines;
        }
        problem.push_back(parse_feature("a/-/a"));
        problem.push_back(parse_feature("a/Pa/-"));
        CAPTURE(notation(problem));
        CHECK(decide(problem).verdict == verdict);
    }
}

TEST_CASE("what is certified has the rank that it needs: certificates are found for all verdicts") {
    RandomProblems random(5);
    for (int i = 0; i < 60; ++i) {
        const Features problem = random.around_a_class(random.below(8));
        CAPTURE(notation(problem));
        const ProblemFile certificate = certify_problem(problem);
        const bool counted = certificate.decision.verdict == Verdict::under_constrained ||
                             certificate.decision.verdict == Verdict::over_constrained;
        CHECK(std::holds_alternative<Unbalanced>(certificate.claim) == counted);
    }
}
