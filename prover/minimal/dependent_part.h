// Where the images of a problem say too much: small parts of it, found by ranks.
#pragma once

#include "prover/reasons/part.h"

#include <vector>

namespace plprove {

/// Parts whose Jacobian has dependent rows at a random place, and that lose this with any view,
/// point or line; up to four. Nothing if the rows of the whole problem are independent.
std::vector<Subproblem> dependent_parts(const Problem& problem);

} // namespace plprove
