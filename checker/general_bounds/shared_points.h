// Three views with a common unknown focal length, two of which share six points
// (proofs/shared_points.md, Theorem W).
#pragma once

#include "checker/problem/problem.h"

namespace checker {
/// A problem with calibrated cameras, in which the two views share five points: a minimal problem
/// has 3/2 times as many solutions as this one, which is minimal, too. None if the theorem does not
/// say so.
std::optional<Problem> calibrated_part(const Problem& problem);
} // namespace checker
