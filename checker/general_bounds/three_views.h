// The degrees of problems in three views, as intersection numbers (proofs/moduli.md, Theorem Q).
#pragma once

#include "checker/problem/problem.h"

namespace checker {
/// The degree: the number of solutions for the cameras, up to motions of space; 0 if the problem is
/// not minimal. Theorem Q of proofs/moduli.md gives it for balanced problems for projective cameras
/// in three views that see everything, where no line has two points, and no point more than four
/// lines. None for other problems.
std::optional<std::size_t> degree_in_three_views(const Problem& problem);
} // namespace checker
