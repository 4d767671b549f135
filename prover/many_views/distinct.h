// Approximate solutions, each solution once.
#pragma once

#include "prover/many_views/system.h"

#include <vector>

namespace plprove::many_views {

/// The first approximation of each solution, in their order. Newton's method tells: paths end less
/// exactly at a solution that is nearly singular, so two ends may look like two solutions. An
/// approximation that it leads far away from is kept as it is.
std::vector<Point> distinct_solutions(const System& system, const Images<Complex>& images,
                                      const std::vector<Point>& approximations);

} // namespace plprove::many_views
