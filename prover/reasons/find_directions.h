// A search for what images say of directions, and of the lines through a point.
#pragma once

#include "prover/reasons/reason_search.h"

namespace plprove {

/// The lines with one point at most: with all points, or without any. Then all lines, without
/// points that close circles.
void consider_directions(ReasonSearch& search, const Problem& problem, ViewSet views);

/// The lines through each point that all these views see, its joins with all others that are on
/// none of these lines, and lines of three of these or more.
void consider_pencils(ReasonSearch& search, const Problem& problem, ViewSet views);

} // namespace plprove
