// The ways in which people name a problem: notation, a name, the authors' number, a signature, and
// the authors' Macaulay2 encoding.
#pragma once

#include "prover/problem/notation.h"

#include <optional>

namespace plprove {

/// Reads a problem given as
/// - a sum of features: `2*Pa/Pa/Pa + P/P/P`;
/// - a name: `Chicago`, `3002_1`, `five-point` (names.h);
/// - the authors' number: `#2394` or `2394`;
/// - a signature: 27 numbers separated by blanks or commas, optionally in braces;
/// - the authors' Macaulay2 encoding `{lines, {view, view, view}}`: `lines` lists for each line the
///   index of its point (from 0) or -1 for a free line, each view is `{seen lines, seen points}`,
///   lists of 0 and 1.
/// Throws NotationError with the column and what was expected, or with the name that was meant.
Features parse_spec(std::string_view text);

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
