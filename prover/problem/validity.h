// What a problem must satisfy beyond its notation, and what to write instead.
#pragma once

#include "prover/problem/problem.h"

namespace plprove {

/// Throws NotationError if there are more points or lines than a problem may have.
void refuse_too_many(const Problem& problem);

/// Throws NotationError if there are too many points or lines, two lines share two points, a view
/// sees two points of a line that it does not see, or two lines of a point that it does not see, or
/// the points have no order of construction.
void refuse_invalid(const Problem& problem);

} // namespace plprove
