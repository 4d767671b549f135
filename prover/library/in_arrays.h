// Cameras and vectors in the plain arrays of the public headers.
#pragma once

#include "prover/library/pointline/solver.h"
#include "prover/solver/solution.h"

namespace pointline {

inline Camera camera(const plprove::Pose<double>& pose) {
    Camera result;
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(result.R.data()) = pose.R;
    Eigen::Map<Eigen::Vector3d>(result.t.data()) = pose.t;
    return result;
}

inline std::array<double, 3> vector(const Eigen::Vector3d& x) {
    return {x[0], x[1], x[2]};
}

} // namespace pointline
