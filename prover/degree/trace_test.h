// The linear trace test: evidence that a set of solutions is complete.
//
// Let one image vector p that occurs in a single equation, linearly, move on a line p + s m, and
// let phi = G(m') / G(m), where G(u) is the equation's left hand side with u in the place of p. As
// s varies, the solutions run through a curve, which the values G maps to the projective plane dual
// to that of p, and the images p + s m cut it by parallel lines there; phi is a coordinate along
// them. Hence the sum of phi over all solutions is affine linear in s, while a sum over a part of
// them, unless that part is invariant under the monodromy of s, is not (A. J. Sommese, J.
// Verschelde, C. W. Wampler, SIAM J. Numer. Anal. 40, 2002). So the sum of the quadratic
// coefficients vanishes.
#pragma once

#include "prover/degree/images.h"

#include <optional>
#include <span>

namespace plprove {

/// The largest of the relative residuals |sum of q| / sum of |q|, where q is the coefficient of s^2
/// in phi, over all image vectors that such a test can move; nothing if every q is zero.
std::optional<double> trace_residual(const CameraSystem& system, const CameraChart& chart,
                                     const std::vector<Complex3>& constants, const Images& images,
                                     std::span<const CameraPoint> solutions, Random& random);

} // namespace plprove
