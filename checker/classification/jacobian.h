// The rows of the Jacobian J of the joint camera map that a feature contributes, at the point that
// a pool describes (FORMAT.md, sections 2 and 3). All entries are integers.
#pragma once

#include "checker/algebra/vector3.h"
#include "checker/file/reader.h"
#include "checker/problem/features.h"

namespace checker {
using Rotation = std::array<IntegerVector, 3>; // by rows, scaled by the norm of its quaternion
using IntegerRow = std::vector<mpz_class>;     // of J: own unknowns, then those of the cameras
using IntegerRows = std::vector<IntegerRow>;

/// Takes X to rotation X + translation.
struct Camera {
    Rotation rotation;
    IntegerVector translation;
};
using Cameras = std::array<Camera, 3>;

/// Where a feature is in space: its point (a point on it, if it is a free line), and the directions
/// of its pins.
struct Placement {
    IntegerVector point;
    std::vector<IntegerVector> directions;
};

inline Rotation rotation_of(const mpz_class& a, const mpz_class& b, const mpz_class& c,
                            const mpz_class& d) {
    if (a == 0 && b == 0 && c == 0 && d == 0) throw Refused("a quaternion is zero");
    return {IntegerVector{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
            IntegerVector{2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
            IntegerVector{2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}};
}

inline IntegerVector rotate(const Rotation& rotation, const IntegerVector& x) {
    return {dot(rotation[0], x), dot(rotation[1], x), dot(rotation[2], x)};
}

/// The first coordinate of the transpose of the rotation times l, and so on.
inline IntegerVector rotate_back(const Rotation& rotation, const IntegerVector& l) {
    IntegerVector sum;
    for (std::size_t i = 0; i < 3; ++i)
        sum = plus(sum, times(l[i], rotation[i]));
    return sum;
}

/// The coefficients of l · (ω_v × arm) in the columns of ω_v. View 1 has none.
inline void set_rotation_columns(IntegerRow& row, const Feature& feature, std::size_t view,
                                 const IntegerVector& l, const IntegerVector& arm) {
    if (view == 0) return;
    const std::size_t first = feature.unknowns() + (view == 1 ? 0 : 5);
    const IntegerVector coefficients = cross(arm, l);
    for (std::size_t i = 0; i < 3; ++i)
        row[first + i] = coefficients[i];
}

/// The coefficients of l · dt_v. The first coordinate of t_2 has no column.
inline void set_translation_columns(IntegerRow& row, const Feature& feature, std::size_t view,
                                    const IntegerVector& l) {
    if (view == 0) return;
    const std::size_t kept = view == 1 ? 1 : 0;
    const std::size_t first = feature.unknowns() + (view == 1 ? 3 : 8);
    for (std::size_t i = kept; i < 3; ++i)
        row[first + i - kept] = l[i];
}

/// The equation l · dx = 0 in a view, where y is the rotated point.
inline IntegerRow point_row(const Feature& feature, std::size_t view, const Camera& camera,
                            const IntegerVector& l, const IntegerVector& y) {
    IntegerRow row(feature.unknowns() + camera_unknowns);
    const IntegerVector own = rotate_back(camera.rotation, l);
    for (std::size_t i = 0; i < feature.point_unknowns(); ++i)
        row[i] = own[i];
    set_rotation_columns(row, feature, view, l, y);
    set_translation_columns(row, feature, view, l);
    return row;
}

/// The equation l · de = 0 in a view, where e is the rotated direction of the pin.
inline IntegerRow direction_row(const Feature& feature, std::size_t pin, std::size_t view,
                                const Camera& camera, const IntegerVector& l,
                                const IntegerVector& e) {
    IntegerRow row(feature.unknowns() + camera_unknowns);
    const std::size_t first = feature.point_unknowns() + 2 * pin;
    const IntegerVector own = rotate_back(camera.rotation, l);
    row[first] = own[0]; // the third coordinate of a direction is kept
    row[first + 1] = own[1];
    set_rotation_columns(row, feature, view, l, e);
    return row;
}

/// The rows of J that one view adds. Throws Refused if the requirements of section 2 are violated.
inline void add_rows_of_view(IntegerRows& rows, const Feature& feature, std::size_t view,
                             const Placement& placement, const Camera& camera) {
    const IntegerVector y = rotate(camera.rotation, placement.point);
    const IntegerVector x = plus(y, camera.translation);
    const bool sees_point = has_view(feature.point, view);
    if (sees_point) {
        if (x[2] == 0) throw Refused("an image of the point has third coordinate 0");
        rows.push_back(point_row(feature, view, camera, {0, x[2], -x[1]}, y));
        rows.push_back(point_row(feature, view, camera, {-x[2], 0, x[0]}, y));
    }
    for (std::size_t pin = 0; pin < feature.pins; ++pin) {
        const IntegerVector& direction = placement.directions[pin];
        if (direction[2] == 0) throw Refused("a direction has third coordinate 0");
        if (!has_view(feature.pin[pin], view)) continue;
        const IntegerVector e = rotate(camera.rotation, direction);
        const IntegerVector l = cross(x, e);
        if (l == IntegerVector{}) throw Refused("the image of a line is zero");
        if (!sees_point) rows.push_back(point_row(feature, view, camera, l, y));
        rows.push_back(direction_row(feature, pin, view, camera, l, e));
    }
}

/// The rows of J of a feature, `equations` many.
inline IntegerRows jacobian_rows(const Feature& feature, const Placement& placement,
                                 const Cameras& cameras) {
    if (cameras[1].translation[0] == 0) throw Refused("the translation of camera 2 begins with 0");
    IntegerRows rows;
    for (std::size_t view = 0; view < 3; ++view)
        add_rows_of_view(rows, feature, view, placement, cameras[view]);
    return rows;
}
} // namespace checker
