// Lines through points, in one view: what noise has torn apart is moved together again.
#pragma once

#include "prover/solver/observation.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace plprove {

/// An image line in pixels: the coefficients of a x + b y + c = 0, and the two points that it was
/// given by, if it was.
struct PixelLine {
    Eigen::Vector3d coefficients;
    std::vector<Eigen::Vector2d> points;
};

PixelLine line_through(const Eigen::Vector2d& p, const Eigen::Vector2d& q);

/// A point, and lines through it.
struct PixelStar {
    Eigen::Vector2d point;
    std::vector<Eigen::Vector3d> lines;
    double moved = 0; ///< the largest distance, in pixels, that a point or line was moved
};

/// The nearest star: a point and lines through it for which the sum of squares of these distances
/// is a minimum: of the point from where it was; of the two points of a line from that line; of the
/// point from a line that was given by coefficients, which keeps its direction. Minimised by turns
/// over the point and the directions, from where they were.
PixelStar nearest_star(const Eigen::Vector2d& point, const std::vector<PixelLine>& lines);

/// What a view sees of a feature, in normalised coordinates: the point and lines given in pixels,
/// moved to the nearest star where they do not meet. `K` takes normalised coordinates to pixels.
/// `moved` grows to the largest distance, in pixels, that something was moved.
Sighting normalised_sighting(const std::optional<Eigen::Vector2d>& point,
                             const std::vector<std::optional<PixelLine>>& lines,
                             const Eigen::Matrix3d& K, double& moved);

} // namespace plprove
