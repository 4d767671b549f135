// Gröbner bases modulo q in the graded reverse lexicographic order, by matrices: Faugère, *A new
// efficient algorithm for computing Gröbner bases (F4)*, 1999, with the criteria of Gebauer and
// Möller, 1988.
#pragma once

#include "prover/model/polynomial.h"

#include <span>
#include <vector>

namespace plprove::model {

/// How large a computation may become; the limits count steps, not seconds, so that the result is
/// the same on every machine.
struct GroebnerLimits {
    std::size_t columns = 40'000;             ///< of a matrix
    std::size_t operations = 20'000'000'000U; ///< multiplications in all matrices, estimated
};

/// The reduced Gröbner basis of the ideal that the polynomials generate, in variables 0, 1, ...,
/// `variables` - 1. Each element has its leading term, with coefficient 1, first, the others in
/// descending order. Throws TooLarge at a limit.
std::vector<std::vector<Term>> groebner_basis(std::span<const Polynomial> polynomials,
                                              const GroebnerLimits& limits = {});

} // namespace plprove::model
