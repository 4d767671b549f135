// Lines through points, in one view: what noise has torn apart is moved together again.
#pragma once

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

} // namespace plprove
