// All solutions at once: a polynomial in one number t, and in t the coordinates, modulo q (the
// rational univariate representation, Rouillier 1999), from solutions with many digits.
#pragma once

#include "prover/geometry/flint.h"
#include "prover/model/lifting/refinement.h"
#include "prover/model/quotient.h"

#include <functional>
#include <map>
#include <optional>

namespace plprove::model {

/// Solutions with so many bits as polynomials modulo q.
class Eliminants {
public:
    /// The solutions must outlive this object.
    Eliminants(const std::vector<RefinedSolution>& solutions, slong bits)
        : solutions_(solutions), bits_(bits) {}

    /// Of as many coordinates as there are factors, with t their sum, each times its factor. The
    /// coefficients are rational numbers: nothing where so many bits do not determine them, or
    /// where q divides a denominator.
    std::optional<Solutions> of(const std::vector<int>& factors);

private:
    Integer denominator_of_sum(const Integer& of_u, std::size_t coordinate);

    const std::vector<RefinedSolution>& solutions_;
    slong bits_;
    /// What denominator_of() says of single coordinates.
    std::map<std::size_t, std::optional<Integer>> denominators_;
};

/// Of the first coordinates, as many as the form has factors.
struct ExactSolutions {
    std::vector<int> form; ///< t is the sum of these coordinates, each times its factor
    Solutions solutions;
};

/// Adds digits until they determine the solutions, by the first of the forms that so few do.
/// `progress`, if any, is told how many bits there are. Nothing if it would take more than
/// `most_bits`. Throws what Refinement::add_digits() throws.
std::optional<ExactSolutions> exact_solutions(Refinement refinement,
                                              const std::vector<std::vector<int>>& forms,
                                              slong most_bits,
                                              const std::function<void(long)>& progress);

} // namespace plprove::model
