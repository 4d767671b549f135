// The monodromy group of the camera solutions of a class: how they are permuted along loops of
// images. Theorems S and P say so (proofs/all_permutations.md, proofs/five_shared_points.md), or
// permutations that fibres prove, put together (proofs/fibres.md).
#pragma once

#include "checker/conclusion/degree_bounds.h"

namespace checker {
/// Of the 20 poses of two views, for five points (Proposition P6).
inline constexpr std::string_view group_of_five_points = "<S2 wr S10";

/// What is known of the group, if there are d solutions: `S<d>`, the symmetric group; `>=A<d>`, it
/// contains the alternating group; `<S8 wr S2 wr S10`, the group of Theorem P, of index 2 in this
/// one, or `<S2 wr S10`, that of five points in two views; `S2 wr S136`, all permutations that keep
/// pairs together; empty if nothing.
std::string group_of(const DegreeBounds& bounds);

/// How it is known: `by fibres: proofs/fibres.md`.
std::string source_of_group(const DegreeBounds& bounds);

/// Whether the group that is known is as expected, both as above.
bool implies_group(const std::string& known, const std::string& expected);
} // namespace checker
