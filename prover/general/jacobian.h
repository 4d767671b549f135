// The Jacobian of the joint camera map of a problem at a point with integer coordinates, modulo q
// (certs/FORMAT.md, section 13).
#pragma once

#include "prover/general/arrangement.h"
#include "prover/geometry/flint.h"

#include <vector>

namespace plprove::general {

/// Coordinates of cameras and scene.
struct Instance {
    /// Of each camera but the first. Calibrated: a quaternion and a translation, 7 integers.
    /// Projective: the 3 x 4 matrix row by row, 12 integers; the first row of camera 2 is 0 0 0 1.
    std::vector<std::vector<std::int64_t>> cameras;
    /// Of the points in order: the coordinates of a free point, or the s of A + s (B - A), where A
    /// and B are the first two points of the line. Then of the lines in order: a point and a
    /// direction of a line without points, the direction of a line with one point.
    std::vector<std::int64_t> scene;
};

/// How many integers Instance::scene has.
int scene_coordinates(const Problem& problem);

/// The Jacobian: dimension_in_views(problem) rows; dimension_in_space(problem) columns, and then
/// camera_dimension(problem.model, problem.views). Assumes the order of construction, and the
/// number of coordinates that the problem needs.
ResidueMatrix jacobian(const Problem& problem, const Instance& instance);

} // namespace plprove::general
