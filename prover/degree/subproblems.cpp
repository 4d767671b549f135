#include "prover/degree/subproblems.h"

#include <algorithm>

namespace plprove {

namespace {

bool is_epipolar(const CameraSystem& system, const CameraEquation& equation,
                 const std::array<int, 2>& pair) {
    return equation.kind == EquationKind::epipolar &&
           system.vectors[static_cast<std::size_t>(equation.vectors[0])].view == pair[0] &&
           system.vectors[static_cast<std::size_t>(equation.vectors[1])].view == pair[1];
}

using Quaternion = std::array<Complex, 4>;

Quaternion quaternion_of(const QuaternionCameras& cameras, int view) {
    if (view == 0) return {1.0, 0.0, 0.0, 0.0};
    return cameras.quaternion[static_cast<std::size_t>(view) - 1];
}

Complex3 centre_of(const QuaternionCameras& cameras, int view) {
    if (view == 0) return {};
    return cameras.centre[static_cast<std::size_t>(view) - 1];
}

/// The rotation from the first view of the pair to the second, as a quaternion with real part 1.
Complex3 relative_rotation(const QuaternionCameras& cameras, const std::array<int, 2>& pair) {
    const auto [a, b, c, d] = quaternion_of(cameras, pair[1]);
    const auto [e, f, g, h] = quaternion_of(cameras, pair[0]);
    const Complex real = a * e + b * f + c * g + d * h;
    return {(b * e - a * f + d * g - c * h) / real, (c * e - a * g + b * h - d * f) / real,
            (d * e - a * h + c * f - b * g) / real};
}

using EssentialMatrix = std::array<Complex, 9>;

/// R_j [c_i - c_j]x R_i^T for the pair i, j, by columns, scaled so that a linear form is 1 on it.
EssentialMatrix essential_matrix(const QuaternionCameras& cameras, const std::array<int, 2>& pair) {
    const Quaternion first = quaternion_of(cameras, pair[0]);
    const Quaternion second = quaternion_of(cameras, pair[1]);
    const Complex3 from = centre_of(cameras, pair[1]);
    Complex3 baseline = centre_of(cameras, pair[0]);
    for (std::size_t k = 0; k < 3; ++k)
        baseline[k] -= from[k];
    EssentialMatrix matrix{};
    Complex form = 0;
    for (std::size_t column = 0; column < 3; ++column) {
        Complex3 axis{};
        axis[column] = 1;
        const Complex3 image = rotate(second, cross(baseline, rotate_back(first, axis)));
        for (std::size_t row = 0; row < 3; ++row) {
            const std::size_t place = 3 * column + row;
            matrix[place] = image[row];
            // A form without meaning, so that it is 0 on no matrix of interest.
            form += std::polar(1.0, 1.0 + 2.3 * static_cast<double>(place)) * image[row];
        }
    }
    for (Complex& entry : matrix)
        entry /= form;
    return matrix;
}

template <std::size_t N>
bool same(const std::array<Complex, N>& a, const std::array<Complex, N>& b) {
    constexpr double tolerance = 1e-5;
    double distance = 0, size = 1;
    for (std::size_t k = 0; k < N; ++k) {
        distance += std::norm(a[k] - b[k]);
        size += std::norm(a[k]);
    }
    return distance < tolerance * tolerance * size;
}

template <class Value>
void add_if_new(std::vector<Value>& values, const Value& value) {
    if (std::ranges::none_of(values, [&](const Value& known) { return same(known, value); }))
        values.push_back(value);
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
            if (std::ssize(poses) < poses_of_five_points &&
                std::ranges::none_of(poses, [&](const Complex3& x) { return same(x, pose); }))
                poses.push_back(pose);
        }
        return std::ssize(poses) == poses_of_five_points &&
               std::ssize(solutions) % poses_of_five_points == 0;
    });
}

PoseCount count_poses(const std::array<int, 2>& pair, const CameraChart& chart,
                      std::span<const CameraPoint> solutions) {
    std::vector<Complex3> poses;
    std::vector<EssentialMatrix> matrices;
    for (const CameraPoint& point : solutions) {
        const QuaternionCameras cameras = chart.cameras(point);
        add_if_new(poses, relative_rotation(cameras, pair));
        add_if_new(matrices, essential_matrix(cameras, pair));
    }
    return {static_cast<int>(poses.size()), static_cast<int>(matrices.size())};
}

} // namespace plprove
