// The degrees of problems in three views, as intersection numbers (proofs/moduli.md, Theorem Q).
#pragma once

#include "checker/problem/problem.h"

namespace checker {
/// How many solutions for its cameras, up to motions of space, the problem has exactly; 0 if it is
/// not minimal; none if the theorem does not say (proofs/moduli.md, Theorem Q). It says so of
/// balanced problems for projective cameras in three views that see everything, where no line has
/// two points, and no point more than four lines.
std::optional<std::size_t> degree_in_three_views(const Problem& problem);
} // namespace checker
