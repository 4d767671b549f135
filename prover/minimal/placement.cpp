#include "prover/minimal/placement.h"

#include "prover/geometry/quaternion.h"

namespace plprove {

Vector3 operator+(const Vector3& a, const Vector3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Vector3 operator*(const Matrix3& m, const Vector3& v) {
    Vector3 result{};
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return result;
}

Vector3 cross(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Matrix3 rotation_matrix(const std::array<std::int64_t, 4>& quaternion) {
    return quaternion_matrix(quaternion);
}

std::optional<std::string> defect(const Cameras& cameras) {
    for (const Camera& camera : cameras)
        if (camera.quaternion == std::array<std::int64_t, 4>{}) return "a quaternion is zero";
    if (cameras.front().translation[0] == 0) return "the first coordinate of t_2 is zero";
    return std::nullopt;
}

std::optional<std::string> defect(const PlacedFeature& placed, const Cameras& cameras) {
    for (const Vector3& direction : placed.directions)
        if (direction[2] == 0) return "the third coordinate of a direction is zero";
    for (int view = 0; view < placed.feature.views(); ++view) {
        const Camera camera = view == 0 ? Camera{} : cameras[static_cast<std::size_t>(view - 1)];
        const Matrix3 rotation = rotation_matrix(camera.quaternion);
        const Vector3 image = rotation * placed.point + camera.translation;
        if (placed.feature.sees_point(view) && image[2] == 0)
            return "the third coordinate of an image point is zero";
        for (int line = 0; line < placed.feature.lines; ++line)
            if (placed.feature.sees_line(view, line) &&
                cross(image, rotation * placed.directions[static_cast<std::size_t>(line)]) ==
                    Vector3{})
                return "a line passes through the centre of a camera that sees it";
    }
    return std::nullopt;
}

} // namespace plprove
