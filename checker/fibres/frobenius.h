// What the polynomial g of a fibre says of a Frobenius element, a permutation of the solutions: its
// cycles are as long as the degrees of the factors of g (proofs/fibres.md).
#pragma once

#include "checker/fibres/extension.h"

#include <string>

namespace checker {
/// Lengths of cycles, in ascending order.
using CycleType = std::vector<std::size_t>;

/// The cycles of the permutation of the roots of g, its highest term left out, which has no
/// multiple root: the degrees of the irreducible factors.
CycleType cycle_type_of(const Polynomial& lower);

/// About how many products of residues this takes.
std::uint64_t products_for_cycle_type(std::size_t degree);

/// What is known of the group of so many solutions, if its permutations over the rational numbers
/// have cycles like these: `S<d>`, the symmetric group; `>=A<d>`, it contains the alternating
/// group; empty if nothing. Other numbers of solutions are ignored.
std::string group_shown_by(const std::vector<CycleType>& cycle_types, std::size_t solutions);

/// Whether the polynomial, its highest term left out, is irreducible and of prime degree.
bool is_irreducible_of_prime_degree(const Polynomial& lower);

/// Whether the permutation is even: g, its highest term left out, has no multiple root, and its
/// discriminant is a square modulo q.
bool frobenius_is_even(const Polynomial& lower);
} // namespace checker
