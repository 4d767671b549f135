// What the polynomial g of a fibre says of a Frobenius element, a permutation of the solutions: its
// cycles are as long as the degrees of the factors of g (proofs/fibres.md).
#pragma once

#include "checker/fibres/extension.h"

namespace checker {
/// Whether the polynomial, its highest term left out, is irreducible and of prime degree.
bool is_irreducible_of_prime_degree(const Polynomial& lower);

/// Whether the permutation is even: g, its highest term left out, has no multiple root, and its
/// discriminant is a square modulo q.
bool frobenius_is_even(const Polynomial& lower);
} // namespace checker
