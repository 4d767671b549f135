// The equations that images put on the cameras (FORMAT.md, section 9).
#pragma once

#include "checker/algebra/vector3.h"
#include "checker/file/complaint.h"
#include "checker/problem/features.h"

namespace checker {
/// Coordinates of an image point or an image line.
using Image = IntegerVector;

/// The images of a feature: of its point, by view, and of its pins (or of the free line).
struct FeatureImages {
    std::array<Image, 3> point{};
    std::array<std::array<Image, 3>, 26> line{};
};

/// A point or a line in one view (0, 1, 2): of the images, or an auxiliary one.
struct ImageVector {
    std::size_t view = 0;
    Image image{};
};

/// Epipolar: of two points. Incidence: of a point and two lines. Pencil: of three lines.
enum class Kind { epipolar, incidence, pencil };

struct CameraEquation {
    Kind kind{};
    std::array<std::size_t, 3> vectors{}; // their places in the system's list
};

/// A line in space: the meet of the planes of two image lines; and the views that see it.
struct SeenLine {
    std::size_t first = 0, second = 0;
    Views views = 0;
};

/// How a feature is found in space: its point is the meet of a ray and a plane.
struct Triangulation {
    std::size_t ray = 0, plane = 0;
    Views seen = 0; // the views that see the point
    std::vector<SeenLine> lines{};
};

/// A problem's equations for its cameras, one for each camera coordinate.
struct CameraSystem {
    std::vector<ImageVector> vectors{};
    std::vector<CameraEquation> equations{};
    std::vector<Triangulation> triangulations{};
};

/// Adds a vector, and returns its place. Throws Refused if it is zero.
inline std::size_t add_vector(CameraSystem& system, std::size_t view, const Image& image) {
    if (image == Image{}) throw Refused("an image, or an auxiliary one, is zero");
    system.vectors.push_back({view, image});
    return system.vectors.size() - 1;
}

/// Adds the auxiliary line through an image point, or the auxiliary point on an image line.
inline std::size_t add_auxiliary(CameraSystem& system, std::size_t place) {
    const auto [view, image] = system.vectors[place];
    return add_vector(system, view, {0, image[2], -image[1]});
}

/// The first of a set of views, which is not empty.
inline std::size_t first_view(Views views) {
    return static_cast<std::size_t>(std::countr_zero(views));
}

/// The images of a feature, by their places in the system's list.
struct PlacedImages {
    std::array<std::size_t, 3> point{};             // by view
    std::vector<std::array<std::size_t, 3>> pins{}; // by view
    std::size_t ray = 0;                            // of the point
    std::size_t ray_view = 0;
    /// For each other view that sees something: a plane through the feature's point.
    std::array<std::size_t, 3> plane{};
    Views planes = 0; // the views that have one
};

/// Adds the image vectors of a feature, with the auxiliary ones that its equations need.
inline PlacedImages add_images(CameraSystem& system, const Feature& feature,
                               const FeatureImages& images) {
    PlacedImages placed;
    placed.pins.resize(feature.pins);
    placed.ray_view = feature.free_line ? 0 : first_view(feature.point);
    for (std::size_t view = 0; view < 3; ++view) {
        const bool sees_point = has_view(feature.point, view);
        if (sees_point) placed.point[view] = add_vector(system, view, images.point[view]);
        for (std::size_t pin = 0; pin < feature.pins; ++pin) {
            if (!has_view(feature.pin[pin], view)) continue;
            placed.pins[pin][view] = add_vector(system, view, images.line[pin][view]);
            if (!sees_point) placed.plane[view] = placed.pins[pin][view];
        }
        if (view == placed.ray_view || !has_view(feature.views, view)) continue;
        placed.planes |= 1U << view;
        if (sees_point) placed.plane[view] = add_auxiliary(system, placed.point[view]);
    }
    const std::size_t view = placed.ray_view;
    placed.ray = feature.free_line ? add_auxiliary(system, placed.pins[0][0]) : placed.point[view];
    return placed;
}

/// Adds the equations of a feature, `weight` many: the table of section 9. Throws Refused if an
/// image is zero.
inline void add_feature(CameraSystem& system, const Feature& feature, const FeatureImages& images) {
    const PlacedImages placed = add_images(system, feature, images);
    const std::size_t i = placed.ray_view;
    const std::size_t j = i == 0 ? 1 : 0;
    const std::size_t k = i == 2 ? 1 : 2;
    for (const std::size_t view : {j, k})
        if (has_view(feature.point, view))
            system.equations.push_back({Kind::epipolar, {placed.point[i], placed.point[view]}});
    if (std::popcount(placed.planes) == 2)
        system.equations.push_back(
            {Kind::incidence, {placed.ray, placed.plane[j], placed.plane[k]}});
    for (std::size_t pin = 0; pin < feature.pins; ++pin)
        if (feature.pin[pin] == all_views)
            system.equations.push_back({Kind::pencil, placed.pins[pin]});

    const Views other_points = feature.point & placed.planes;
    const Views plane_views = other_points != 0 ? other_points : placed.planes;
    Triangulation& triangulation = system.triangulations.emplace_back();
    triangulation.ray = placed.ray;
    triangulation.plane = placed.plane[first_view(plane_views)];
    triangulation.seen = feature.point;
    for (std::size_t pin = 0; pin < feature.pins; ++pin) {
        const Views seen = feature.pin[pin];
        const Views but_first = seen & (seen - 1);
        triangulation.lines.push_back(
            {placed.pins[pin][first_view(seen)], placed.pins[pin][first_view(but_first)], seen});
    }
}
} // namespace checker
