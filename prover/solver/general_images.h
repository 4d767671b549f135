// Images of problems in general, as users have them, for the engine of many views.
#pragma once

#include "prover/many_views/moving_images.h"
#include "prover/solver/reconstruction.h"

namespace plprove {

/// What all views see of the problem, for the equations. Assumes that they see everything, and that
/// the points of each line are on one.
many_views::Images<many_views::Complex> images_for_equations(const Problem& problem,
                                                             const SeenImages& images);

/// The same images in coordinates in which they are around the origin, about as large as 1: the
/// calibration takes these to the given ones. For cameras without intrinsics.
SeenImages centred(const SeenImages& images);

} // namespace plprove
