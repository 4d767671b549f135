// The degrees of problems for projective cameras whose views give twelve equations each, by
// counting the invariants of GL_4 (proofs/moduli.md, Theorem T).
#pragma once

#include "checker/problem/problem.h"

#include <gmpxx.h>

namespace checker {
/// r(n) of Theorem T: the multiplicity of det^3n in the tensor product of representations of GL_4,
/// one for each point, with the lines through it, and for each free line; none if the theorem says
/// nothing of the problem.
std::optional<mpz_class> invariants(const Problem& problem, int n);

/// How many solutions for its cameras, up to motions of space, a minimal problem has at most: a
/// difference of these numbers. None if Theorem T says nothing of the problem, as when general
/// arrangements are not stable.
std::optional<std::size_t> degree_by_invariants(const Problem& problem);
} // namespace checker
