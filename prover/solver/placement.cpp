#include "prover/solver/placement.h"

#include "prover/monodromy/solution_set.h"
#include "prover/solver/alignment.h"
#include "prover/solver/plan.h"
#include "prover/solver/synthetic.h"
#include "prover/three_views/path_follower.h"

#include <algorithm>

namespace plprove {

namespace {

constexpr int places = 8;           // that are tried
constexpr int scenes = 5;           // that paths are followed to
constexpr std::size_t sample = 100; // of the solutions, for which they are

using Targets = std::vector<std::vector<Eigen::Vector3d>>;

/// What the views see of some synthetic scenes of the class.
Targets images_of_scenes(const CameraSystem& system, std::size_t number) {
    const SolvePlan how = plan(problem_of(label_classes()[number]));
    Targets result;
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        const SyntheticScene scene = synthetic_scene(how.problem, seed);
        result.push_back(class_images(how, system, scene.images.observation));
    }
    return result;
}

/// A start whose images can be exchanged.
class MovableStart {
public:
    MovableStart(const CameraSystem& system, const Start& start)
        : system_(system), start_(start), tracked_(tracked_system(system, start.chart)) {}

    /// The solutions at these images that paths from the given ones lead to. They differ, or
    /// nothing is returned; nor where a path is lost.
    std::optional<std::vector<CameraPoint>> move(const std::vector<CameraPoint>& solutions,
                                                 const Images& to) const {
        PathFollower follower(tracked_);
        const TrackedImages way = moving_images(system_, start_.constants, start_.images, to);
        PathFollower::Ends ends = follower.follow_quickly(way, solutions);
        fill(ends, solutions,
             [&](const auto& open) { return follower.follow_double_double(way, open); });
        SolutionSet<CameraPoint> different;
        for (const auto& end : ends) {
            if (!end || different.find(*end)) return std::nullopt;
            different.add(*end);
        }
        return different.points();
    }

    /// How many steps paths from these solutions of these images take to the targets.
    std::uint64_t steps(const std::vector<CameraPoint>& solutions, const Images& from,
                        const Targets& targets) const {
        PathFollower follower(tracked_);
        for (const auto& target : targets) {
            const Images nearest = align(system_, from, target).nearest;
            follower.follow_quickly(moving_images(system_, start_.constants, from, nearest),
                                    solutions);
        }
        return follower.counts().steps;
    }

private:
    const CameraSystem& system_;
    const Start& start_;
    TrackedSystem tracked_;
};

Images random_images(const CameraSystem& system, Random& random) {
    Images images;
    for (std::size_t k = 0; k < system.free.size(); ++k)
        images.push_back(unit(random.complex3()));
    return images;
}

} // namespace

Start well_placed(Start start, std::uint64_t seed) {
    const CameraSystem system = camera_system(label_classes()[start.number]);
    const Targets targets = images_of_scenes(system, start.number);
    const MovableStart movable(system, start);
    const auto end = start.solutions.begin() +
                     static_cast<std::ptrdiff_t>(std::min(sample, start.solutions.size()));
    const std::vector<CameraPoint> some(start.solutions.begin(), end);

    std::uint64_t fewest = movable.steps(some, start.images, targets);
    std::optional<Images> best;
    Random random(seed, start.number);
    for (int place = 0; place < places; ++place) {
        const Images images = random_images(system, random);
        const auto moved = movable.move(some, images);
        if (!moved) continue;
        const std::uint64_t steps = movable.steps(*moved, images, targets);
        if (steps >= fewest) continue;
        fewest = steps;
        best = images;
    }
    if (!best) return start;
    auto solutions = movable.move(start.solutions, *best);
    if (!solutions) return start;
    return {start.number, start.chart, start.constants, std::move(*best), std::move(*solutions)};
}

} // namespace plprove
