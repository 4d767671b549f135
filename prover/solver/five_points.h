// The five-point problem, by elimination: all relative poses of two cameras that see five points.
//
// The five pairs put linear equations on the essential matrix E, so E = x X + y Y + z Z + W for a
// basis X, Y, Z, W of their null space. E satisfies ten cubic equations (D. Nister, PAMI 2004).
// Elimination in the 20 monomials of degree at most 3 leaves the matrix of multiplication by x on
// the ten of degree at most 2. Its eigenvectors are the ten solutions (H. Stewenius, C. Engels,
// D. Nister, ISPRS 2006).
#pragma once

#include "prover/solver/solution.h"

#include <array>

namespace plprove {

/// The poses (R, t) of the second camera, the first one being [I | 0]: at most 20, two for each
/// essential matrix, with t up to scale. `first` and `second` are the image points, in normalised
/// coordinates. Fewer where the images are degenerate: equal points, or points whose linear
/// equations are dependent.
std::vector<ComplexPose> five_point_poses(const std::array<Eigen::Vector3d, 5>& first,
                                          const std::array<Eigen::Vector3d, 5>& second);

} // namespace plprove
