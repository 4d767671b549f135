// Theorem S: loops of images permute the cameras of a problem in all ways
// (proofs/all_permutations.md).
#pragma once

#include "checker/problem/classes.h"

namespace checker {
/// Whether the theorem says so of the minimal problems with this signature: their group is then the
/// symmetric group. If not, nothing is said.
bool has_all_permutations(const Signature& signature);
} // namespace checker
