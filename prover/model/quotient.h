// The solutions of a system with finitely many, from its Gröbner basis: all at once, as polynomials
// in one number t (the rational univariate representation, Rouillier 1999).
#pragma once

#include "prover/model/polynomial.h"
#include "prover/model/univariate.h"

#include <optional>
#include <utility>
#include <vector>

namespace plprove::model {

/// Solutions modulo g, which has no multiple roots: the value of each unknown is a polynomial in t
/// of a degree less than that of g; t is a sum of multiples of unknowns.
struct Solutions {
    Univariate polynomial; ///< g
    std::vector<Univariate> unknowns;
};

/// The solutions of multiplicity 1 of the ideal with this reduced Gröbner basis, in `variables`
/// variables; the values of the first ones, as many as `form` has coefficients; t is the sum of
/// these, each times its coefficient. Nothing if there are infinitely many solutions. Throws
/// TooLarge if there are more than `most`.
std::optional<Solutions> solutions_of(const std::vector<std::vector<Term>>& basis,
                                      std::size_t variables, const std::vector<int>& form,
                                      std::size_t most);

} // namespace plprove::model
