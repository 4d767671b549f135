// A search for central motions.
#pragma once

#include "prover/reasons/motion.h"

namespace plprove {

/// Motions of a kind with generators, a few points and lines of the part; of cameras that are not
/// projective, without.
std::vector<CameraMotion> generators_of(const Problem& problem, const Subproblem& part,
                                        MotionKind kind);

/// A central motion by which the images of the part satisfy a condition; nothing if the search
/// finds none.
std::optional<CameraMotion> find_central_motion(const Problem& problem, const Subproblem& part);

/// The same for small parts: elements about a point, each with generators of its own.
std::optional<CameraMotion> find_any_central_motion(const Problem& problem, const Subproblem& part);

} // namespace plprove
