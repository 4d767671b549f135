// A search for motions of cameras.
#pragma once

#include "prover/reasons/reason_search.h"

namespace plprove {

/// Motions of one camera, of some, and of all; the part may lose what they do not keep.
void consider_camera_motions(ReasonSearch& search, const Problem& problem, const Subproblem& part);

/// Motions of the cameras that see nothing of the part but points in a plane, whatever plane
/// through some points and lines; of all these cameras or some.
void consider_planes(ReasonSearch& search, const Problem& problem, const Subproblem& part);

} // namespace plprove
