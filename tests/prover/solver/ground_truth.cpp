// Images are made of a known scene: its cameras and its features are among the solutions.
#include "prover/solver/solve.h"
#include "prover/solver/start.h"
#include "tests/prover/solver/truth.h"

#include <Eigen/Geometry>
#include <doctest/doctest.h>
#include <map>

using namespace plprove;

namespace {

constexpr double exact = 1e-8;

/// Starts that several tests need.
const Start& start_of(std::size_t number) {
    static std::map<std::size_t, Start> starts;
    const auto found = starts.find(number);
    if (found != starts.end()) return found->second;
    return starts.emplace(number, find_start(number, 0)).first->second;
}

Solver solver_of(const Features& problem) {
    SolvePlan how = plan(problem);
    if (!how.number) return Solver(std::move(how));
    const std::size_t number = *how.number;
    return {std::move(how), start_of(number)};
}

/// The feature's points and lines in space are those of the scene, or missing.
void check_feature(const SpaceFeature& found, const SyntheticScene& scene, std::size_t f) {
    const Eigen::Vector3cd truth = scene.points[f].cast<Complex>();
    if (found.point) CHECK((*found.point - truth).norm() < 1e3 * exact);
    for (std::size_t line = 0; line < found.lines.size(); ++line) {
        if (!found.lines[line]) continue;
        const Eigen::Vector3d direction = found.lines[line]->direction.real();
        CHECK(direction.cross(scene.directions[f][line]).norm() < 1e3 * exact);
        const Eigen::Vector3d offset = (found.lines[line]->point - truth).real();
        CHECK(offset.cross(direction).norm() < 1e3 * exact);
    }
}

/// Solves for the images of a scene, and returns the solution that is the truth.
Solution check_truth(const std::string& notation_of_problem, std::uint64_t seed) {
    CAPTURE(notation_of_problem);
    CAPTURE(seed);
    const SyntheticScene scene = synthetic_scene(parse_features(notation_of_problem), seed);
    const Answer answer = solver_of(scene.problem).solve(scene.images, SolveOptions{});
    CHECK(answer.lost == 0);
    CHECK(answer.found == answer.degree);
    CHECK(std::ssize(answer.solutions) == answer.found);
    const Solution& truth = solver_tests::nearest(answer, scene);
    CHECK(solver_tests::distance(truth, scene) < exact);
    CHECK(truth.real);
    CHECK(truth.residual < 1e-6);
    for (std::size_t f = 0; f < scene.problem.size(); ++f) {
        CAPTURE(f);
        check_feature(truth.features[f], scene, f);
        for (std::size_t v = 0; v < scene.cameras.size(); ++v) {
            const bool sees = scene.problem[f].sees_point(static_cast<int>(v));
            CHECK(truth.features[f].in_front[v] ==
                  (sees && truth.features[f].point ? std::optional(true) : std::nullopt));
        }
    }
    // Complex rotations may have large entries, which cancel in an image.
    std::size_t precise = 0;
    for (const Solution& solution : answer.solutions) {
        if (solution.real) CHECK(solution.residual < 1e-5);
        precise += solution.residual < 1e-5;
    }
    CHECK(10 * precise >= 8 * answer.solutions.size());
    return truth;
}

} // namespace

TEST_CASE("the true cameras are among the solutions: problems that cover all features") {
    // Features and views in other orders than those of the label classes.
    for (const char* problem :
         {"Pa/Pa/Pa + P/P/P + Pa/Pa/Pa", "a/a/a + 3*P/P/P",
          "Pab/b/a + a/P/Pa + a/Pa/P + a/P/a + 3*-/P/P + a/a/P + b/Pab/a",
          "3*P/-/P + Pa/Pa/a + P/Pa/a + a/Pa/P + P/a/a", "P/P/P + a/a/a + a/Pa/P + 4*P/-/P",
          "b/a/Pab + P/P/- + Pabcdef/Pabcdef/Pabcdef", "Pa/Pa/Pa + a/P/Pa + Pa/P/a + 3*-/P/P",
          "P/P/P + Pabcde/Pabcde/Pabcde", "a/Pa/Pa + P/a/Pa + P/Pa/a + 4*-/P/P",
          "a/P/Pa + Pabc/Pabc/Pabc + 3*-/P/P", "3*P/P/- + Pab/Pab/Pab + P/P/P",
          "Pa/a/Pa + Pa/Pa/a + Pa/a/P + 3*P/-/P", "Pa/Pa/Pa + Pabcd/Pabcd/Pabcd"})
        check_truth(problem, 2);
}

TEST_CASE("the true cameras are among the solutions: problems that are not reduced") {
    // Pins seen by one or two views, dangling ones, points seen once, lines seen twice.
    for (const char* problem : {"Pab/Pa/Pa + Pabc/Pac/Pa + P/P/P + P/-/- + a/a/-",
                                "Pa/Pab/Pab + Pa/Pa/Pa + P/P/P + P/a/-", "3*P/P/P + a/Pa/a"}) {
        const SolvePlan how = plan(parse_features(problem));
        REQUIRE(how.number);
        check_truth(problem, 3);
    }
    for (const char* problem : {"a/P/P + a/P/P + a/P/a + a/a/P + b/P/a + b/a/P + 3*-/P/P",
                                "P/P/P + a/a/a + a/P/P + 4*P/P/-"})
        check_truth(problem, 5);
}

TEST_CASE("the rest of the structure is triangulated, and what is open is missing") {
    const Solution truth = check_truth("2*Pa/Pa/Pa + P/P/P + P/-/- + Pa/a/- + a/a/- + Pa/-/-", 2);
    CHECK(!truth.features[3].point); // seen by one view
    CHECK(truth.features[4].point);  // on the plane of a line
    CHECK(truth.features[4].lines[0]);
    CHECK(truth.features[5].lines[0]);
    CHECK(!truth.features[6].point);
    CHECK(!truth.features[6].lines[0]);
}

TEST_CASE("in two views the true cameras are among the 20 poses of five points") {
    for (std::uint64_t seed = 0; seed < 20; ++seed)
        check_truth("5*P/P", seed);
    check_truth("Pa/P + 3*P/P + Pa/Pa + a/a + Pa/a", 1);
}

TEST_CASE("a problem with its views in another order has the same solutions") {
    const Features problem = parse_features("P/P/P + a/a/a + a/P/Pa + 4*P/P/-");
    const SyntheticScene scene = synthetic_scene(problem, 4);
    const Answer answer = solver_of(problem).solve(scene.images, SolveOptions{});
    const std::array<int, 3> from{0, 2, 1}; // the first view stays, and so does the frame
    Features relabeled;
    SeenImages images = scene.images;
    for (std::size_t f = 0; f < problem.size(); ++f) {
        relabeled.push_back(relabel_views(problem[f], from));
        std::swap(images.observation[f][1], images.observation[f][2]);
    }
    const Answer other = solver_of(relabeled).solve(images, SolveOptions{});
    REQUIRE(other.found == answer.found);
    // Rotations do not depend on the scale, which is that of another pair of views.
    for (const Solution& solution : answer.solutions) {
        double least = 1;
        for (const Solution& candidate : other.solutions)
            least = std::min(least, (candidate.cameras[1].R - solution.cameras[2].R).norm() +
                                        (candidate.cameras[2].R - solution.cameras[1].R).norm());
        CHECK(least < 1e-6 * (1 + solution.cameras[1].R.norm() + solution.cameras[2].R.norm()));
    }
}

TEST_CASE("what is neither minimal nor camera-minimal is refused, and a start of another class") {
    CHECK_THROWS(plan(parse_features("4*P/P")));
    CHECK_THROWS(plan(parse_features("P/P/P")));
    CHECK_THROWS(Solver(plan(parse_features("3*P/P/P + a/a/a")), start_of(2394)));
    CHECK_THROWS(Solver(plan(parse_features("5*P/P")), start_of(2394)));
    CHECK_THROWS(Solver(plan(parse_features("3*P/P/P + a/a/a"))));
}

TEST_CASE("the condition is the largest change of the cameras that small changes make") {
    const Features problem = parse_features("2*Pa/Pa/Pa + P/P/P");
    const SyntheticScene scene = synthetic_scene(problem, 11);
    const Solver solver = solver_of(problem);
    const Solution truth = solver_tests::nearest(solver.solve(scene.images, SolveOptions{}), scene);
    REQUIRE(truth.condition);
    constexpr double noise = 1e-7;
    double largest = 0;
    for (std::size_t f = 0; f < 3; ++f)
        for (std::size_t view = 0; view < 3; ++view) {
            SyntheticScene moved = scene;
            Sighting& sighting = moved.images.observation[f][view];
            const Eigen::Vector3d across = sighting.point->unitOrthogonal();
            const Eigen::Vector3d before = *sighting.point;
            sighting.point = (before.normalized() + noise * across) * before.norm();
            for (auto& line : sighting.lines) // through the point, and another point as before
                line = sighting.point->cross(line->cross(before)).normalized();
            const Answer answer = solver.solve(moved.images, SolveOptions{});
            largest = std::max(largest,
                               solver_tests::distance(solver_tests::nearest(answer, scene), scene));
        }
    CHECK(largest > 0.02 * noise * *truth.condition);
    CHECK(largest < 2 * noise * *truth.condition);
}
