// A search for central motions.
#pragma once

#include "prover/reasons/motion.h"

namespace plprove {

/// A central motion by which the images of the part satisfy a condition; nothing if the search
/// finds none.
std::optional<CameraMotion> find_central_motion(const Problem& problem, const Subproblem& part);

} // namespace plprove
