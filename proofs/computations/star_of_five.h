// Lemma V7 of proofs/stars_in_several_views.md: a point with five pins and three free lines in five
// views, as a matrix of linear forms on the plane; one example modulo q = 2^61 - 1.
#pragma once

#include "proofs/computations/residue_matrices.h"

#include <array>
#include <cstddef>
#include <vector>

namespace proofs {

/// What one view shows: the directions of five pins, vectors with two coordinates.
using ImageStar = std::array<std::array<Residue, 2>, 5>;

inline Residue bracket(const std::array<Residue, 2>& y, const std::array<Residue, 2>& z) {
    return y[0] * z[1] - y[1] * z[0];
}

/// The one camera of a plane, up to scale, that sees four pins in the directions (1, 0, 0),
/// (0, 1, 0), (0, 0, 1), (1, 1, 1) and the fifth in the direction x as this view shows them: three
/// columns in a row.
inline ResidueRow camera_of_star(const ImageStar& y, const std::array<Residue, 3>& x) {
    std::array<Residue, 3> c, dx;
    for (std::size_t i = 0; i < 3; ++i) {
        c[i] = bracket(y[i], y[3]);
        dx[i] = bracket(y[i], y[4]) * x[i];
    }
    ResidueRow camera;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const Residue factor = c[j] * dx[k] - c[k] * dx[j];
        camera.push_back(factor * y[i][0]);
        camera.push_back(factor * y[i][1]);
    }
    return camera;
}

using FiveImages = std::array<ImageStar, 5>;

inline FiveImages generic_images(Residues& random) {
    FiveImages images;
    for (ImageStar& image : images)
        for (auto& direction : image)
            for (Residue& number : direction)
                number = random.next();
    return images;
}

/// The five cameras, one a row.
inline ResidueMatrix cameras_of_star(const FiveImages& images, const std::array<Residue, 3>& x) {
    ResidueMatrix rows;
    for (const ImageStar& image : images)
        rows.push_back(camera_of_star(image, x));
    return rows;
}

/// The six minors of size 5 of the matrix of the cameras.
inline ResidueRow minors_of_cameras(const FiveImages& images, const std::array<Residue, 3>& x) {
    const ResidueMatrix rows = cameras_of_star(images, x);
    ResidueRow minors;
    for (std::size_t omitted = 0; omitted < 6; ++omitted) {
        ResidueMatrix part = rows;
        for (ResidueRow& row : part)
            row.erase(row.begin() + static_cast<std::ptrdiff_t>(omitted));
        minors.push_back(determinant_of(part));
    }
    return minors;
}

/// The nine points where these minors vanish that are no solutions.
inline std::vector<std::array<Residue, 3>> spurious_points(const FiveImages& images) {
    constexpr Residue one{1}, zero{};
    std::vector<std::array<Residue, 3>> points{
        {one, zero, zero}, {zero, one, zero}, {zero, zero, one}, {one, one, one}};
    for (const ImageStar& y : images) {
        points.emplace_back();
        for (std::size_t i = 0; i < 3; ++i)
            points.back()[i] = bracket(y[i], y[3]) * bracket(y[i], y[4]).inverse();
    }
    return points;
}

/// Whether the minors have no common zero on a generic line of the plane.
inline bool no_curve_of_degenerate_stars(const FiveImages& images, Residues& random) {
    constexpr std::size_t degree = 5;
    const ResidueMatrix line = random.matrix(2, 3);
    ResidueMatrix values(6); // of each minor
    for (std::size_t t = 0; t <= degree; ++t) {
        std::array<Residue, 3> x;
        for (std::size_t i = 0; i < 3; ++i)
            x[i] = line[0][i] + Residue::of(t) * line[1][i];
        const ResidueRow minors = minors_of_cameras(images, x);
        for (std::size_t i = 0; i < 6; ++i)
            values[i].push_back(minors[i]);
    }
    ResidueMatrix forms;
    for (const ResidueRow& of_minor : values)
        forms.push_back(interpolated(of_minor));
    return have_no_common_zero(forms);
}

/// Whether they are different, and the minors vanish there.
inline bool spurious_points_are_nine(const FiveImages& images) {
    const auto points = spurious_points(images);
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (const Residue minor : minors_of_cameras(images, points[i]))
            if (minor != Residue{}) return false;
        for (std::size_t j = 0; j < i; ++j) {
            const ResidueMatrix two{{points[i].begin(), points[i].end()},
                                    {points[j].begin(), points[j].end()}};
            if (rank_of(two) < 2) return false;
        }
    }
    return points.size() == 9;
}

} // namespace proofs
