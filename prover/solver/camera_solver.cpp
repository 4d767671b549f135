#include "prover/solver/camera_solver.h"

#include "prover/degree/scene.h"
#include "prover/solver/alignment.h"
#include "prover/solver/zero_set.h"

namespace plprove {

namespace {

/// Zeros that are no more than rounding errors away from being degenerate are no solutions.
constexpr double least_nondegeneracy = 1e-13;

Images complex_images(const std::vector<Eigen::Vector3d>& images) {
    Images result;
    for (const Eigen::Vector3d& x : images)
        result.push_back({x[0], x[1], x[2]});
    return result;
}

/// The zero that is the complex conjugate, which real images have, too.
CameraPoint conjugate(const CameraChart& chart, const CameraPoint& zero) {
    QuaternionCameras cameras = chart.cameras(zero);
    for (auto& quaternion : cameras.quaternion)
        for (Complex& x : quaternion)
            x = std::conj(x);
    for (Complex3& centre : cameras.centre)
        for (Complex& x : centre)
            x = std::conj(x);
    return chart.point(cameras);
}

/// Drops ends that two paths share: one of the paths has jumped.
void drop_equal(PathFollower::Ends& ends) {
    ZeroSet seen;
    std::vector<std::size_t> first; // which path leads to each of them
    std::vector<std::size_t> equal;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (!ends[i]) continue;
        if (const auto known = seen.find(*ends[i])) {
            equal.push_back(i);
            equal.push_back(first[*known]);
        } else {
            seen.add(*ends[i]);
            first.push_back(i);
        }
    }
    for (const std::size_t i : equal)
        ends[i].reset();
}

} // namespace

CameraSolver::CameraSolver(Start start)
    : start_(std::move(start)), system_(camera_system(label_classes()[start_.number])),
      tracked_(tracked_system(system_, start_.chart)) {}

PathFollower::Ends CameraSolver::polished(const Images& images,
                                          const PathFollower::Ends& ends) const {
    std::vector<std::size_t> indices;
    std::vector<CameraPoint> zeros;
    for (std::size_t i = 0; i < ends.size(); ++i)
        if (ends[i]) {
            indices.push_back(i);
            zeros.push_back(*ends[i]);
        }
    const TrackedImages at_rest = moving_images(system_, start_.constants, images, images);
    auto better = newton(fastest_double_double_tracker(), 1e-16, tracked_, at_rest, zeros);
    fill(better, zeros, [&](const auto& open) {
        return newton(fastest_triple_double_tracker(), 1e-22, tracked_, at_rest, open);
    });
    PathFollower::Ends result(ends.size());
    for (std::size_t k = 0; k < zeros.size(); ++k)
        result[indices[k]] = better[k];
    return result;
}

PathFollower::Ends CameraSolver::follow(PathFollower& follower, const Images& to,
                                        const Images& images, Effort effort) const {
    const TrackedImages straight = moving_images(system_, start_.constants, start_.images, to);
    auto ends = polished(images, follower.follow_quickly(straight, start_.solutions));
    drop_equal(ends);
    if (effort == Effort::once) return ends;
    fill(ends, start_.solutions, [&](const auto& open) {
        return polished(images, follower.follow_double_double(straight, open));
    });
    return ends;
}

FoundCameras CameraSolver::solve(const std::vector<Eigen::Vector3d>& images, Effort effort) const {
    const int most_ways = effort == Effort::thorough ? 3 : 1;
    const Alignment alignment = align(system_, start_.images, images);
    const Images target = complex_images(alignment.turned);
    const std::vector<Complex3> vectors = image_vectors(system_, start_.constants, target);
    Random random(0, start_.number);
    PathFollower follower(tracked_);
    ZeroSet found;
    const auto add = [&](const CameraPoint& zero) {
        if (nondegeneracy(system_, vectors, start_.chart.cameras(zero)) > least_nondegeneracy)
            found.add(zero);
    };
    int before = -1; // where a way finds nothing new, others are no better
    for (int way = 0; way < most_ways && found.size() < start_.degree() && found.size() != before;
         ++way) {
        before = found.size();
        const Images to =
            way == 0 ? alignment.nearest : rephased(alignment.nearest, Phases::near_one, random);
        const PathFollower::Ends ends = follow(follower, to, target, effort);
        for (const auto& end : ends)
            if (end) add(*end);
        // Conjugates of solutions are solutions, too: some paths need not have arrived.
        PathFollower::Ends conjugates;
        for (const auto& end : ends)
            if (end && found.size() < start_.degree())
                conjugates.emplace_back(conjugate(start_.chart, *end));
        for (const auto& end : polished(target, conjugates))
            if (end) add(*end);
    }
    FoundCameras result{{}, start_.degree() - found.size(), follower.counts().steps};
    for (const CameraPoint& zero : found.zeros())
        result.cameras.push_back(turned_back(alignment, start_.chart.cameras(zero)));
    return result;
}

} // namespace plprove
