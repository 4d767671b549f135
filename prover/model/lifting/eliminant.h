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

/// Solutions as polynomials modulo q, whose coefficients are rational numbers.
class Eliminants {
public:
    /// The refinement must outlive this object.
    explicit Eliminants(const Refinement& refinement) : refinement_(refinement) {}

    /// How many bits will do for of(). Nothing where those that there are do not determine the
    /// denominators: some more than these have do.
    std::optional<slong> bits_for(const std::vector<int>& factors);

    /// Of as many coordinates as there are factors, with t their sum, each times its factor. To be
    /// asked after bits_for(), with as many bits as it said. Nothing where these do not determine
    /// the coefficients, or where q divides a denominator.
    std::optional<Solutions> of(const std::vector<int>& factors) const;

private:
    bool find_denominator(const std::vector<int>& factors);
    Integer denominator_of_sum(const std::vector<int>& factors, std::size_t coordinate) const;

    const Refinement& refinement_;
    /// Of the polynomials whose zeros are these sums; nothing where the bits are too few.
    std::map<std::vector<int>, std::optional<Integer>> denominators_;
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
