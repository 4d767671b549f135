// The scene behind a camera solution: how far it is from being degenerate.
#pragma once

#include "prover/three_views/images.h"

namespace plprove {

/// How close, relative to the sizes involved, the cameras come to violating a non-degeneracy of
/// FORMAT.md, section 9: isotropic rotations, a ray in the plane that it should meet, a point in
/// the centre of a camera that sees it, a line through such a centre. 0 if one is violated;
/// solutions that are no more than rounding errors away from that are no solutions of the problem.
double nondegeneracy(const CameraSystem& system, const std::vector<Complex3>& vectors,
                     const QuaternionCameras& cameras);

} // namespace plprove
