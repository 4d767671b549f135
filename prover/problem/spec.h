// The ways in which people name a problem: notation, a name, the authors' number, a signature, and
// the authors' Macaulay2 encoding.
#pragma once

#include "prover/problem/notation.h"

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

} // namespace plprove
