// The equations of a registration problem with numbers: their values at given rotations.
#pragma once

#include "prover/solver/known_scene.h"
#include "prover/solver/templates/frame.h"

#include <vector>

namespace plprove {

/// The values of all equations, in the order of FORMAT. The scene is in the frame.
template <class Scalar>
std::vector<Scalar> equation_values(const KnownScene<Scalar>& scene, templates::Frame frame,
                                    const Eigen::Matrix<Scalar, 3, 3>& rotation);

/// The translation of a camera with this rotation that sees the scene, by least squares. In any
/// coordinates.
Eigen::Vector3cd translation(const KnownScene<std::complex<double>>& scene,
                             const Eigen::Matrix3cd& rotation);

} // namespace plprove
