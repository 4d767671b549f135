// Points of the domain of the joint camera map, in small integers: cameras by integer quaternions
// and translations, features by points and directions (certs/FORMAT.md, section 2).
#pragma once

#include "prover/problem/feature.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace plprove {

using Vector3 = std::array<std::int64_t, 3>;
using Matrix3 = std::array<Vector3, 3>;

Vector3 operator+(const Vector3& a, const Vector3& b);
Vector3 operator*(const Matrix3& m, const Vector3& v);
Vector3 cross(const Vector3& a, const Vector3& b);

/// A camera [R | t], R the integer matrix of the quaternion (a, b, c, d): a rotation times its
/// squared norm.
struct Camera {
    std::array<std::int64_t, 4> quaternion{1, 0, 0, 0};
    Vector3 translation{};
};

/// The integer matrix R with R^T R = (a^2 + b^2 + c^2 + d^2)^2 I.
Matrix3 rotation_matrix(const std::array<std::int64_t, 4>& quaternion);

/// A feature placed in space. For a free line `point` is a point on it and `directions` its
/// direction; else there is one direction for each pin.
struct PlacedFeature {
    Feature feature;
    Vector3 point{};
    std::vector<Vector3> directions;
};

/// Cameras 2, 3, ... (camera 1 is [I | 0]).
using Cameras = std::vector<Camera>;

/// What makes the cameras inadmissible (FORMAT.md, section 2, requirements), or nothing.
std::optional<std::string> defect(const Cameras& cameras);

/// What makes the feature inadmissible before these cameras, or nothing.
std::optional<std::string> defect(const PlacedFeature& placed, const Cameras& cameras);

/// Coordinates up to this size, with quaternions up to a third of it, keep all entries of Jacobians
/// below 2^55.
inline constexpr std::int64_t max_coordinate = 50;

} // namespace plprove
