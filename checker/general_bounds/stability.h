// Whether general arrangements of points and lines are stable (proofs/moduli.md, section 6).
#pragma once

#include "checker/problem/problem.h"

namespace checker {
/// Whether they are, for a problem whose views give twelve equations each, where no line has two
/// points, and no point more than four lines (Lemma T4).
bool general_arrangements_are_stable(const Problem& problem);
} // namespace checker
