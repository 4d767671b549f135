#include "prover/solver/extension.h"

#include "prover/minimal/obstruction.h"
#include "prover/solver/five_points.h"
#include "prover/solver/poses.h"
#include "prover/solver/templates/values.h"
#include "prover/system/in_parts.h"

namespace plprove {

namespace {

/// Templates of 109 to 149 rows take 0.3 to 0.9 times as long as paths for scenes, and about as
/// long for random images. Those of 222 rows and more take 0.6 to 2.2 times as long for scenes, and
/// twice as long for random images (docs/solve.md).
constexpr std::size_t most_rows = 150;

std::size_t rows(const templates::Template& found) {
    const auto columns = templates::RotationRing(found.frame).monomials(found.degree);
    return columns.size() - found.basis.size();
}

/// The five points that both views see.
std::array<Eigen::Vector3d, 5> shared_points(const ClassSights& sights, int view, int other) {
    std::array<Eigen::Vector3d, 5> points;
    std::size_t next = 0;
    for (std::size_t f = 0; f < sights.features().size(); ++f) {
        const Feature& feature = sights.features()[f];
        if (feature.sees_point(view) && feature.sees_point(other))
            points[next++] = sights.point(f, view);
    }
    return points;
}

/// Whether it is the second one of a pair of complex conjugates.
bool is_second_of_pair(const ComplexPose& pose) {
    Eigen::Index row = 0, column = 0;
    pose.R.imag().cwiseAbs().maxCoeff(&row, &column);
    return pose.R(row, column).imag() < 0;
}

} // namespace

std::optional<ExtensionSolver> ExtensionSolver::make(const Signature& signature) {
    const std::array<int, 3> shared = shared_points(problem_of(signature)); // by pairs 12, 13, 23
    std::optional<templates::Template> best;
    int best_third = 0;
    for (int third = 0; third < 3; ++third) {
        if (shared[static_cast<std::size_t>(2 - third)] != 5) continue;
        auto found = templates::best_template(templates::registration(signature, third));
        if (!found || (best && rows(*best) <= rows(*found))) continue;
        best = std::move(found);
        best_third = third;
    }
    if (!best || rows(*best) > most_rows) return std::nullopt;
    return ExtensionSolver(best_third, *best);
}

std::vector<QuaternionCameras> ExtensionSolver::cameras(const CameraSystem& system,
                                                        const std::vector<Eigen::Vector3d>& images,
                                                        std::uint64_t attempt,
                                                        unsigned threads) const {
    const ClassSights sights(system, images);
    const int first = (third_ + 1) % 3, second = (third_ + 2) % 3;
    std::vector<ComplexPose> pairs = five_point_poses(shared_points(sights, first, second),
                                                      shared_points(sights, second, first));
    std::erase_if(pairs, is_second_of_pair);
    std::vector<std::vector<QuaternionCameras>> of_pairs(pairs.size());
    in_parts(pairs.size(), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            of_pairs[k] = with_third(sights, pairs[k], attempt);
    });
    std::vector<QuaternionCameras> result;
    for (const auto& cameras : of_pairs)
        result.insert(result.end(), cameras.begin(), cameras.end());
    return result;
}

std::vector<QuaternionCameras> ExtensionSolver::with_third(const ClassSights& sights,
                                                           const ComplexPose& pair,
                                                           std::uint64_t attempt) const {
    const auto scene = known_scene(sights, third_, pair);
    const FramedScene framed = in_frame(scene, registration_.frame(), attempt);
    std::vector<QuaternionCameras> result;
    for (const Eigen::Matrix3cd& rotation : registration_.rotations(framed.scene)) {
        std::vector<ComplexPose> poses(3);
        poses[static_cast<std::size_t>((third_ + 2) % 3)] = pair;
        ComplexPose& third = poses[static_cast<std::size_t>(third_)];
        third.R = framed.turned_back(rotation);
        third.t = translation(scene, third.R);
        result.push_back(quaternion_cameras(poses));
    }
    return result;
}

} // namespace plprove
