// What images say of directions, and of the lines through a point (certs/FORMAT.md, section 13).
#pragma once

#include "prover/reasons/motion.h"

namespace plprove {

/// What the images say of directions, less the parameters of these and of cameras without their
/// translations; of the core with its translations. A line of the part joins its points. Nothing if
/// the motion is not as FORMAT.md requires.
std::optional<int> excess_of_directions(const Problem& problem, const Subproblem& part,
                                        const CameraMotion& motion);

/// What the images say of the lines through a point that all views of the part see, and of its
/// joins with the other points, less the parameters of these and of their maps to pencils. The
/// joins with three points of a line are in a plane. Nothing if the point is not as FORMAT.md
/// requires.
std::optional<int> excess_of_pencils(const Problem& problem, const Subproblem& part,
                                     const CameraMotion& motion);

} // namespace plprove
