#include "prover/solver/registration_frame.h"

#include "prover/three_views/random.h"

namespace plprove {

namespace {

using Eigen::Matrix3cd;
using Eigen::Vector3cd;

Vector3cd cross(const Vector3cd& a, const Vector3cd& b) {
    return bilinear_cross<Complex>(a, b);
}

Vector3cd unit(const Vector3cd& a) {
    return a / std::sqrt(bilinear<Complex>(a, a));
}

/// A rotation with a multiple of `a` as this row, and the next row orthogonal to `other`.
Matrix3cd rotation_with(int row, const Vector3cd& a, const Vector3cd& other) {
    Matrix3cd rotation;
    rotation.row(row) = unit(a).transpose();
    const Vector3cd next = unit(cross(a, other));
    rotation.row((row + 1) % 3) = next.transpose();
    rotation.row((row + 2) % 3) = cross(unit(a), next).transpose();
    return rotation;
}

/// The points of two lines that are nearest to each other, where these are real.
std::array<Vector3cd, 2> feet(const KnownScene<Complex>::Line& a,
                              const KnownScene<Complex>::Line& b) {
    const Vector3cd normal = cross(a.direction, b.direction);
    const Complex square = bilinear<Complex>(normal, normal);
    const Vector3cd between = b.point - a.point;
    const Complex along_a = determinant<Complex>(between, b.direction, normal) / square;
    const Complex along_b = determinant<Complex>(between, a.direction, normal) / square;
    return {a.point + along_a * a.direction, b.point + along_b * b.direction};
}

/// The rotations and the origin, without the scene.
FramedScene way_to(const KnownScene<Complex>& scene, templates::Frame frame, Random random) {
    const auto any = [&random] {
        const double x = random.real(), y = random.real(), z = random.real();
        return Vector3cd(x, y, z);
    };
    const Vector3cd a = any(), b = any(), c = any(), d = any();
    FramedScene way;
    way.origin = scene.stars.empty() ? Vector3cd(0, 0, 0) : scene.stars[0].point;
    switch (frame) {
    case templates::Frame::general:
        way.space = rotation_with(0, a, b);
        way.view = rotation_with(2, c, d);
        break;
    case templates::Frame::line:
        way.space = rotation_with(0, scene.lines[0].direction, b);
        way.view = rotation_with(2, scene.lines[0].image, d);
        break;
    case templates::Frame::points:
        way.space = rotation_with(0, scene.stars[1].point - scene.stars[0].point, b);
        way.view = rotation_with(2, cross(scene.stars[0].image, scene.stars[1].image), d);
        break;
    case templates::Frame::lines:
        way.origin = scene.lines[0].point;
        // The next row is orthogonal to the first two: it is the second axis; the third is the
        // common perpendicular.
        way.space = rotation_with(0, scene.lines[0].direction,
                                  cross(scene.lines[0].direction, scene.lines[1].direction));
        way.view = rotation_with(2, scene.lines[0].image, d);
        break;
    }
    return way;
}

} // namespace

FramedScene in_frame(KnownScene<Complex> scene, templates::Frame frame, std::uint64_t attempt) {
    if (frame == templates::Frame::lines) {
        const auto [first, second] = feet(scene.lines[0], scene.lines[1]);
        scene.lines[0].point = first;
        scene.lines[1].point = second;
    }
    FramedScene framed = way_to(scene, frame, Random(attempt, 0));
    framed.scene = mapped<Complex>(
        scene, [&](const Vector3cd& x) -> Vector3cd { return framed.space * (x - framed.origin); },
        [&](const Vector3cd& x) -> Vector3cd { return framed.space * x; },
        [&](const Vector3cd& x) -> Vector3cd { return framed.view * x; });
    return framed;
}

} // namespace plprove
