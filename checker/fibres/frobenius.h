// What the polynomial g of a fibre says of a Frobenius element, a permutation of the solutions: its
// cycles are as long as the degrees of the factors of g (proofs/fibres.md).
#pragma once

#include "checker/fibres/extension.h"

#include <functional>
#include <string>

namespace checker {
bool is_prime(std::size_t n);

/// Lengths of cycles, in ascending order.
using CycleType = std::vector<std::size_t>;

/// How many points they have together.
std::size_t points_of(const CycleType& lengths);

/// Whether permutations with these cycles are even.
bool is_even(const CycleType& lengths);

/// Whether a power of the permutation is one cycle, of a prime length from `least` to `most`.
bool has_prime_cycle(const CycleType& lengths, std::size_t least, std::size_t most);

/// The cycles of the permutation of the roots of g, its highest term left out, which has no
/// multiple root: the degrees of the irreducible factors.
CycleType cycle_type_of(const Polynomial& lower);

/// The cycles of the fibres of one problem that have most solutions, given by their g, the highest
/// terms left out. None if there is one such fibre only, as no group follows: that spares the time.
/// `spend` is told the effort of each.
std::vector<CycleType> cycle_types_of(const std::vector<Polynomial>& fibres,
                                      const std::function<void(std::uint64_t)>& spend);

/// Whether the solutions are known to be one orbit of the group.
enum class Orbits { one, unknown };

/// What is known of the group of so many solutions, if its permutations over the rational numbers
/// have cycles like these: `S<d>`, the symmetric group; `>=A<d>`, it contains the alternating
/// group; empty if nothing. Other numbers of solutions are ignored.
std::string group_shown_by(const std::vector<CycleType>& cycle_types, std::size_t solutions,
                           Orbits orbits);
} // namespace checker
