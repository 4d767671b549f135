// The ways to name a problem that only problems in general have: their notation, PLMP's names and
// PLMP's encoding.
#pragma once

#include "prover/problem/problem.h"

#include <optional>
#include <string_view>

namespace plprove {

/// Reads
/// - notation with shared lines, more than three views, or `projective:` in front;
/// - a name of PLMP, Table 1, that prover/problem/names.h does not have: `1021_1`, `3200_4`;
/// - PLMP's encoding `(5,0,{{0,1,3},{0,2,4},{1,2}})`: the number of points, that of lines without
///   points, and of each other line the points, from 0. Complete visibility; the number of views is
///   the one that makes the problem balanced, or follows as a fourth entry. `projective:` may stand
///   in front.
/// Nothing if the text is none of these. Throws NotationError if it is one, with a mistake.
std::optional<Problem> parse_general_spec(std::string_view text);

} // namespace plprove
