// Larger problems that fix the cameras in the same way: what a user may add to a minimal problem so
// that it stays minimal.
#pragma once

#include "prover/minimal/change.h"

#include <vector>

namespace plprove {

/// What may be added to a minimal problem in two or three views: a free line, a point, a point with
/// a pin; to one of its points a pin, to one of its free lines a point. All ways to see them that
/// one step of the reduction takes back, and that leave the problem balanced. By Theorem 4 of the
/// paper the larger problem is minimal, with the same degree.
std::vector<Change> extensions(const Features& problem);

} // namespace plprove
