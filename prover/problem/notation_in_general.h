// Reading and writing the notation for problems in general. docs/notation.md specifies it.
#pragma once

#include "prover/problem/notation.h"
#include "prover/problem/problem.h"

#include <string>
#include <string_view>

namespace plprove {

/// Reads `projective: 3*PL/PL/PL + Pa/Pa/Pa`: a problem in 2 to 12 views. Points that are not in an
/// order of construction are put into one. Lines are numbered as they appear: feature by feature,
/// new capital letters first, then small letters, in alphabetical order. Throws NotationError with
/// the column, or with the points and lines that cannot be, and what to write instead.
Problem parse_problem(std::string_view text);

/// The problem in notation: first the points in their order, each with its pins, then the free
/// lines. parse_problem() reads it again; its lines may then have other numbers.
std::string notation(const Problem& problem);

} // namespace plprove
