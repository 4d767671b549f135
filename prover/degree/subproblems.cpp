#include "prover/degree/subproblems.h"

#include <algorithm>

namespace plprove {

namespace {

constexpr std::size_t poses_of_five_points = 20;

bool is_epipolar(const CameraSystem& system, const CameraEquation& equation,
                 const std::array<int, 2>& pair) {
    return equation.kind == EquationKind::epipolar &&
           system.vectors[static_cast<std::size_t>(equation.vectors[0])].view == pair[0] &&
           system.vectors[static_cast<std::size_t>(equation.vectors[1])].view == pair[1];
}

/// The rotation from the first view of the pair to the second, as a quaternion with real part 1.
Complex3 relative_rotation(const QuaternionCameras& cameras, const std::array<int, 2>& pair) {
    const auto quaternion = [&](int view) {
        return view == 0 ? std::array<Complex, 4>{1.0, 0.0, 0.0, 0.0}
                         : cameras.quaternion[static_cast<std::size_t>(view) - 1];
    };
    const auto [a, b, c, d] = quaternion(pair[1]);
    const auto [e, f, g, h] = quaternion(pair[0]);
    const Complex real = a * e + b * f + c * g + d * h;
    return {(b * e - a * f + d * g - c * h) / real, (c * e - a * g + b * h - d * f) / real,
            (d * e - a * h + c * f - b * g) / real};
}

bool same(const Complex3& a, const Complex3& b) {
    constexpr double tolerance = 1e-5;
    double distance = 0, size = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        distance += std::norm(a[k] - b[k]);
        size += std::norm(a[k]);
    }
    return distance < tolerance * tolerance * size;
}

} // namespace

Subproblems subproblems(const CameraSystem& system) {
    Subproblems result;
    for (const std::array<int, 2> pair : {std::array{0, 1}, std::array{0, 2}, std::array{1, 2}}) {
        const auto shared = std::ranges::count_if(system.features, [&](const Feature& feature) {
            return feature.sees_point(pair[0]) && feature.sees_point(pair[1]);
        });
        if (shared != 5) continue;
        result.five_points.push_back(pair);
        result.tested &= std::ranges::any_of(system.free, [&](const FreeVector& free) {
            return free.single_equation >= 0 &&
                   is_epipolar(system,
                               system.equations[static_cast<std::size_t>(free.single_equation)],
                               pair);
        });
    }
    constexpr int rotation_parameters = 6;
    result.rotations = std::ranges::count(system.equations, EquationKind::pencil,
                                          &CameraEquation::kind) >= rotation_parameters;
    result.tested &= !result.rotations;
    return result;
}

bool has_all_poses(const Subproblems& subproblems, const CameraChart& chart,
                   std::span<const CameraPoint> solutions) {
    return std::ranges::all_of(subproblems.five_points, [&](const std::array<int, 2>& pair) {
        std::vector<Complex3> poses;
        for (const CameraPoint& point : solutions) {
            const Complex3 pose = relative_rotation(chart.cameras(point), pair);
            if (poses.size() < poses_of_five_points &&
                std::ranges::none_of(poses, [&](const Complex3& x) { return same(x, pose); }))
                poses.push_back(pose);
        }
        return poses.size() == poses_of_five_points && solutions.size() % poses_of_five_points == 0;
    });
}

} // namespace plprove
