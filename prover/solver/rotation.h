// The rotation of a quaternion, which may be complex.
#pragma once

#include "prover/geometry/quaternion.h"

#include <Eigen/Core>

namespace plprove {

/// Assumes that the squares of the coordinates do not add up to 0.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 3> rotation_of_quaternion(const std::array<Scalar, 4>& quaternion) {
    const auto rows = quaternion_matrix(quaternion);
    Eigen::Matrix<Scalar, 3, 3> matrix;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = rows[i][j];
    const auto& [a, b, c, d] = quaternion;
    return matrix / (a * a + b * b + c * c + d * d);
}

} // namespace plprove
