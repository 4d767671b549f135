// Samples: of extensions and in two views all cameras with the points in front, else the true ones
// of most scenes; and the paths that lead there, each with images of its own.
#include "prover/solver/sample_solver.h"

#include "prover/problem/notation.h"
#include "prover/solver/alignment.h"
#include "prover/solver/poses.h"
#include "prover/solver/reconstruction.h"
#include "prover/solver/solve.h"
#include "prover/solver/synthetic.h"
#include "prover/three_views/path_follower.h"

#include <algorithm>
#include <doctest/doctest.h>

using namespace plprove;

namespace {

using RealCameras = std::vector<Pose<double>>;

bool are_equal(const RealCameras& some, const RealCameras& others) {
    double largest = 0;
    for (std::size_t v = 0; v < some.size(); ++v)
        largest = std::max({largest, (some[v].R - others[v].R).cwiseAbs().maxCoeff(),
                            (some[v].t - others[v].t).cwiseAbs().maxCoeff()});
    return largest < 1e-5;
}

bool contains(const std::vector<RealCameras>& all, const RealCameras& one) {
    return std::ranges::any_of(all,
                               [&](const RealCameras& other) { return are_equal(other, one); });
}

CameraSystem system_of(const char* problem) {
    return camera_system(label_classes()[*plan(parse_features(problem)).number]);
}

} // namespace

TEST_CASE("of problems without paths a sample has all real cameras with the points in front") {
    for (const char* name : {"5*P/P", "2*P/P/P + a/Pa/Pa + 2*-/P/P", "3*P/P/P + 2*-/P/P"}) {
        CAPTURE(name);
        const Features problem = parse_features(name);
        const Solver solver = make_solver(problem);
        const SampleSolver samples(problem);
        const auto points = std::ranges::count_if(problem, &Feature::has_point);
        std::size_t wanted = 0, given = 0;
        for (std::uint64_t seed = 0; seed < 5; ++seed) {
            CAPTURE(seed);
            const SyntheticScene scene = synthetic_scene(problem, seed);
            const auto some = samples.solve(scene.images);
            for (const Solution& solution :
                 solver.solve(scene.images, {{}, false, false}).solutions) {
                if (solution.in_front < points) continue;
                ++wanted;
                CHECK(contains(some, real_poses(solution.cameras)));
            }
            given += some.size();
        }
        CHECK(wanted >= 5);
        CHECK(given == wanted);
    }
}

TEST_CASE("a few paths lead to the true cameras of most scenes, and only to solutions") {
    constexpr int scenes = 30;
    for (const char* name : {"2*Pa/Pa/Pa + P/P/P", "3*P/P/P + a/a/a", "3*P/P/P + P/P/- + P/-/P"}) {
        CAPTURE(name);
        const Features problem = parse_features(name);
        const SampleSolver samples(problem, 32);
        const auto points = std::ranges::count_if(problem, &Feature::has_point);
        int with_truth = 0;
        for (std::uint64_t seed = 0; seed < scenes; ++seed) {
            const SyntheticScene scene = synthetic_scene(problem, seed);
            const auto found = samples.solve(scene.images);
            with_truth += contains(found, scene.cameras);
            for (const RealCameras& cameras : found) {
                const Solution solution = real_solution(scene.images, cameras);
                CHECK(solution.residual < 1e-3);
                CHECK(solution.in_front == points);
            }
        }
        // Paths to solutions as they come would find 312 / 32, a tenth.
        CHECK(with_truth >= scenes * 2 / 3);
    }
}

TEST_CASE("more paths find the true cameras more often") {
    const Features problem = parse_features("2*Pa/Pa/Pa + P/P/P");
    const SampleSolver few(problem, 4), many(problem, 64);
    int by_few = 0, by_many = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const SyntheticScene scene = synthetic_scene(problem, seed);
        by_few += contains(few.solve(scene.images), scene.cameras);
        by_many += contains(many.solve(scene.images), scene.cameras);
    }
    CHECK(by_few < by_many);
    CHECK(by_many >= 17);
}

TEST_CASE("anchors satisfy the camera equations") {
    for (const char* name : {"2*Pa/Pa/Pa + P/P/P", "3*P/P/P + P/P/- + P/-/P", "P/P/P + 4*a/a/a",
                             "a/Pa/Pa + 4*-/P/P + 4*P/-/P"}) {
        CAPTURE(name);
        const CameraSystem system = system_of(name);
        for (std::uint64_t number = 0; number < 10; ++number) {
            const Anchor anchor = random_anchor(system, number);
            const Images images = complex_images(anchor.images);
            const TrackedImages at_rest = moving_images(system, anchor.constants, images, images);
            const CameraPoint start{
                0, 0, 0, 0, 0, 0, 0, 0, anchor.third[0], anchor.third[1], anchor.third[2]};
            const auto end = newton(fastest_tracker(), 1e-12,
                                    tracked_system(system, standard_chart()), at_rest, {start});
            REQUIRE(end[0]);
            for (std::size_t k = 0; k < start.size(); ++k)
                CHECK(std::abs((*end[0])[k] - start[k]) < 1e-9);
        }
    }
}

TEST_CASE("paths with images of their own end where they end one by one, to the last bit") {
    const CameraSystem system = system_of("2*Pa/Pa/Pa + P/P/P");
    const TrackedSystem tracked = tracked_system(system, standard_chart());
    std::vector<TrackedImages> ways;
    std::vector<CameraPoint> starts;
    constexpr std::size_t paths = 21; // more than lanes
    for (std::uint64_t number = 0; number < paths; ++number) {
        const Anchor anchor = random_anchor(system, number);
        const Images images = complex_images(anchor.images);
        Random random(number, 1);
        ways.push_back(moving_images(system, anchor.constants, images,
                                     rephased(images, Phases::near_one, random)));
        starts.push_back(
            {0, 0, 0, 0, 0, 0, 0, 0, anchor.third[0], anchor.third[1], anchor.third[2]});
    }
    std::vector<CameraPoint> ends(paths), one_by_one(paths);
    std::vector<TrackOutcome> outcomes(paths), outcomes_one_by_one(paths);
    const auto steps = fastest_tracker_of_each()(tracked, ways.data(), {}, paths, starts.data(),
                                                 ends.data(), outcomes.data())
                           .steps;
    std::uint64_t steps_one_by_one = 0;
    for (std::size_t i = 0; i < paths; ++i)
        steps_one_by_one += fastest_tracker()(tracked, ways[i], {}, 1, &starts[i], &one_by_one[i],
                                              &outcomes_one_by_one[i])
                                .steps;
    CHECK(steps == steps_one_by_one);
    CHECK(outcomes == outcomes_one_by_one);
    CHECK(ends == one_by_one);
    CHECK(std::ranges::count(outcomes, TrackOutcome::arrived) >= 15);
}
