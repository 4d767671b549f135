// The Jacobian of problems in general, and the reasons against minimality, against ranks that are
// computed a second way.
#include "prover/minimal/decision.h"
#include "prover/minimal/problem_record.h"
#include "prover/problem/notation.h"
#include "prover/problem/signature.h"
#include "tests/prover/minimal/random_arrangements.h"
#include "tests/prover/minimal/second_jacobian.h"

#include <algorithm>
#include <doctest/doctest.h>

using namespace plprove;
using Random = RandomArrangements;

namespace {

int corank(const Problem& problem) {
    return dimension_in_views(problem) - SecondJacobian(problem, 1).rank();
}

/// A part of the problem, and a motion that may keep its points, at random.
std::pair<Subproblem, CameraMotion> random_motion(const Problem& problem, Random& random) {
    Subproblem part = whole(problem);
    std::erase_if(part.points, [&](int) { return random.below(3) == 0; });
    std::erase_if(part.lines, [&](int) { return random.below(6) == 0; });
    ViewSet moving = part.views;
    if (random.below(2) == 0) moving &= static_cast<ViewSet>(1 + random.below(63));
    const bool is_star = !part.points.empty() && random.below(2) == 0;
    const int points = static_cast<int>(part.points.size());
    const int centre = is_star ? part.points[static_cast<std::size_t>(random.below(points))] : -1;
    CameraMotion motion =
        is_star ? star(centre, moving) : CameraMotion{.kind = MotionKind::plane, .moving = moving};
    if (problem.cameras == &calibrated_cameras) return {part, motion};
    // All keep each point, or each camera that slides those that it sees.
    const bool own = is_star && random.below(2) == 0;
    for (const int point : part.points) {
        if (point == centre) continue;
        if (!own) motion.points.push_back(point);
        for (CentralElement& element : motion.elements)
            if (own && (problem.points[static_cast<std::size_t>(point)] & element.views) != 0)
                element.points.push_back(point);
    }
    for (const int line : part.lines)
        if (random.below(5) == 0) motion.lines.push_back(line);
    return {part, motion};
}

} // namespace

TEST_SUITE_BEGIN("problems in general: ranks");

TEST_CASE("the Jacobian has the rank of the joint camera map, written a second way") {
    Random random(20);
    for (int i = 0; i < 400; ++i) {
        const Problem problem = random.problem();
        CAPTURE(notation(problem));
        const ResidueMatrix matrix = jacobian_modulo_q(problem, random.instance(problem));
        CHECK(nmod_mat_rank(matrix.get()) == SecondJacobian(problem, 7).rank());
    }
}

TEST_CASE("the Jacobian has a row for each dimension of the images: none is superfluous") {
    // The images of one view alone, with the scene free, have its dimension.
    Random random(21);
    for (int i = 0; i < 100; ++i) {
        Problem problem = random.problem();
        for (ViewSet& seen : problem.points)
            seen &= 1;
        for (Line& line : problem.lines)
            line.seen &= 1;
        CAPTURE(notation(problem));
        CHECK(SecondJacobian(problem, 3).rank() == dimension_in_views(problem));
    }
}

TEST_CASE("there are the motions that a reason claims, or more") {
    Random random(22);
    int with_motions = 0;
    for (int i = 0; i < 4000; ++i) {
        const Problem problem = random.problem();
        const auto [part, motion] = random_motion(problem, random);
        if (moving_views(motion) == 0 || !is_part(problem, part)) continue;
        const std::optional<int> claimed = motions(problem, part, motion);
        if (!claimed || *claimed < 1) continue;
        ++with_motions;
        CAPTURE(notation(problem));
        const Problem alone = problem_of(problem, part);
        const int parameters = dimension_in_space(alone) + alone.cameras->dimension(alone.views);
        CHECK(SecondJacobian(alone, 1).rank() <= parameters - *claimed);
    }
    CHECK(with_motions > 200);
}

TEST_CASE("the images of a problem satisfy the conditions of its parts") {
    Random random(25);
    int overconstrained = 0;
    for (int i = 0; i < 1500; ++i) {
        const Problem problem = random.problem();
        const Subproblem part = random_motion(problem, random).first;
        if (!is_part(problem, part) || *excess(problem, part, {}) < 1) continue;
        ++overconstrained;
        CAPTURE(notation(problem));
        CHECK(*excess(problem, part, {}) <= corank(problem));
    }
    CHECK(overconstrained > 100);
}

TEST_CASE("three lines that meet in a point stay together: the point is no part to leave out") {
    const Problem problem = parse_problem("PLMN/PLMN + 2*PL/PL + 2*PM/PM + 2*PN/PN");
    Subproblem part = whole(problem);
    std::erase(part.points, 0);
    CHECK_FALSE(is_part(problem, part));
    part.lines = {0, 1};
    CHECK_FALSE(is_part(problem, part)); // N has two points left, but L, M and N went through it
    part.points = {1, 2, 3, 4, 5};
    CHECK(is_part(problem, part));
}

TEST_CASE("balanced problems at random: the certificate agrees with the rank") {
    Random random(23);
    int balanced = 0, decided = 0;
    for (int i = 0; i < 3000; ++i) {
        const Problem problem = random.problem();
        if (!is_balanced(problem)) continue;
        ++balanced;
        CAPTURE(notation(problem));
        const bool minimal = corank(problem) == 0;
        std::optional<bool> certified; // nothing where no reason is found
        try {
            certified = is_minimal(certify(problem));
        } catch (const std::runtime_error&) {
        }
        CHECK(certified.value_or(false) == minimal);
        decided += certified ? 1 : 0;
    }
    CHECK(balanced > 30);
    CHECK(10 * decided >= 9 * balanced);
}

TEST_CASE("label classes: the joint camera map, written a second way, has the certified rank") {
    const std::vector<Signature>& classes = label_classes();
    int samples = 0;
    for (std::size_t number = 0; number < classes.size(); ++number) {
        const Features features = problem_of(classes[number]);
        const int deficiency = obstruction(features).deficiency();
        // Few minimal classes, and the deficient ones of each kind.
        if (number % (deficiency == 0 ? 1511 : deficiency == 1 ? 97 : 29) != 0) continue;
        CAPTURE(notation(features));
        CHECK(corank(problem_of(features)) == deficiency);
        ++samples;
    }
    CHECK(samples > 100);
}

TEST_CASE("label classes have the same verdict as problems in general") {
    const std::vector<Signature>& classes = label_classes();
    int not_minimal = 0;
    for (std::size_t number = 0; number < classes.size(); number += 409) {
        const Features problem = problem_of(classes[number]);
        const std::string text = plprove::notation(problem);
        CAPTURE(text);
        const bool minimal = is_minimal(certify(parse_problem(text)));
        CHECK(minimal == (decide(problem).verdict == Verdict::minimal));
        not_minimal += minimal ? 0 : 1;
    }
    CHECK(not_minimal > 0);
    for (const std::size_t number : {0, 1, 3, 5093, 130456}) {
        const std::string text = plprove::notation(problem_of(classes[number]));
        CAPTURE(text);
        CHECK(is_minimal(certify(parse_problem(text))) ==
              (decide(problem_of(classes[number])).verdict == Verdict::minimal));
    }
}

TEST_SUITE_END();
