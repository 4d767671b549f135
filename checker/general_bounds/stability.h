// Whether general arrangements of points and lines are stable (proofs/moduli.md, section 6).
#pragma once

#include "checker/problem/problem.h"

namespace checker {
/// Whether Lemma T4 says so, for a problem whose views give twelve equations each and where no line
/// has two points. It says nothing where a point is on more than four lines.
bool general_arrangements_are_stable(const Problem& problem);
} // namespace checker
