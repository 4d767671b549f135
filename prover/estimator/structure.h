// Points and lines in space from their images, for given cameras, and how far their images are off.
#pragma once

#include "prover/estimator/matches.h"
#include "prover/solver/solution.h"

namespace plprove {

using Poses = std::vector<Pose<double>>;

/// The line of the points X with X x direction = moment (Plücker coordinates); the direction has
/// length 1 and is orthogonal to the moment.
struct PluckerLine {
    Eigen::Vector3d direction, moment;
};

/// The point of space near the rays of the views that see it. Nothing if it is not in front of
/// them, or fewer than two views see it, or their rays are parallel.
std::optional<Eigen::Vector3d> space_point(const PointMatch& match, const Poses& cameras);

/// The line of space near the planes of the views that see it; nothing where fewer than two views
/// do, or their planes are equal.
std::optional<PluckerLine> space_line(const LineMatch& match, const Poses& cameras);

/// The line a x + b y + c = 0 of the image, in normalised coordinates.
Eigen::Vector3d image_of(const PluckerLine& line, const Pose<double>& camera);

/// The square of the largest distance, in pixels, of the image of X from where a view sees it.
double squared_error(const Eigen::Vector3d& point, const PointMatch& match, const Poses& cameras,
                     const std::vector<PinholeIntrinsics>& intrinsics);

/// The square of the largest distance, in pixels, of an end of a segment from the image of the
/// line.
double squared_error(const PluckerLine& line, const LineMatch& match, const Poses& cameras,
                     const std::vector<PinholeIntrinsics>& intrinsics);

} // namespace plprove
