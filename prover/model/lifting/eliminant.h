// All solutions at once: a polynomial in one number t, and in t the coordinates, modulo q (the
// rational univariate representation, Rouillier 1999), from solutions with many digits.
#pragma once

#include "prover/model/lifting/refinement.h"
#include "prover/model/quotient.h"

#include <optional>

namespace plprove::model {

/// Modulo q, with t the sum of the coordinates, each times its factor. The coefficients are
/// rational numbers: nothing where so many bits do not determine them, or where q divides a
/// denominator.
std::optional<Solutions> eliminant(const std::vector<RefinedSolution>& solutions,
                                   const std::vector<int>& factors, slong bits);

} // namespace plprove::model
