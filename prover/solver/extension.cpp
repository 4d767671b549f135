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

/// Entries of rotations with smaller imaginary parts may be real: these have few digits.
constexpr double maybe_real = 1e-3;

bool may_be_real(const Eigen::Matrix3cd& rotation) {
    return rotation.imag().cwiseAbs().maxCoeff() < maybe_real;
}

/// Whether the rays of all points meet in front of both views, for one sign of the translation.
bool meet_in_front(const ComplexPose& pose, const std::array<Eigen::Vector3d, 5>& first,
                   const std::array<Eigen::Vector3d, 5>& second) {
    const Eigen::Matrix3d R = pose.R.real();
    const Eigen::Vector3d t = pose.t.real();
    int positive = 0, negative = 0;
    for (std::size_t k = 0; k < 5; ++k) {
        // Depths with second * a = R first * b + t.
        Eigen::Matrix<double, 3, 2> rays;
        rays << second[k], -R * first[k];
        const Eigen::Vector2d depths = (rays.transpose() * rays).inverse() * (rays.transpose() * t);
        positive += depths.minCoeff() > 0;
        negative += depths.maxCoeff() < 0;
    }
    return positive == 5 || negative == 5;
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
                                                        std::uint64_t attempt, unsigned threads,
                                                        Wanted wanted) const {
    const ClassSights sights(system, images);
    const int first = (third_ + 1) % 3, second = (third_ + 2) % 3;
    const auto points = shared_points(sights, first, second);
    const auto others = shared_points(sights, second, first);
    std::vector<ComplexPose> pairs = five_point_poses(points, others);
    std::erase_if(pairs, [&](const ComplexPose& pose) {
        if (wanted == Wanted::all) return is_second_of_pair(pose);
        return !may_be_real(pose.R) || !meet_in_front(pose, points, others);
    });
    std::vector<std::vector<QuaternionCameras>> of_pairs(pairs.size());
    in_parts(pairs.size(), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            of_pairs[k] = with_third(sights, pairs[k], attempt, wanted);
    });
    std::vector<QuaternionCameras> result;
    for (const auto& cameras : of_pairs)
        result.insert(result.end(), cameras.begin(), cameras.end());
    return result;
}

std::vector<QuaternionCameras> ExtensionSolver::with_third(const ClassSights& sights,
                                                           const ComplexPose& pair,
                                                           std::uint64_t attempt,
                                                           Wanted wanted) const {
    const auto scene = known_scene(sights, third_, pair);
    const FramedScene framed = in_frame(scene, registration_.frame(), attempt);
    std::vector<QuaternionCameras> result;
    for (const Eigen::Matrix3cd& rotation : registration_.rotations(framed.scene)) {
        if (wanted == Wanted::real_in_front && !may_be_real(rotation)) continue;
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
