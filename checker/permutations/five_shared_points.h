// Theorem P: two views share five points, and a third one is found for each of their poses in as
// many ways as possible (proofs/five_shared_points.md).
#pragma once

#include "checker/problem/classes.h"

#include <optional>

namespace checker {
/// The only two views that share five points; none if there are more such pairs, or none.
std::optional<Views> views_with_five_points(const Signature& signature);

/// Whether the theorem says so of the minimal problems with this signature: loops of images permute
/// the third cameras of each of the 20 poses in all ways, whatever they do with those of others. If
/// not, nothing is said.
bool has_all_permutations_of_third_cameras(const Signature& signature);
} // namespace checker
