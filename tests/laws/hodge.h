// The Hodge index of the degrees. Features of weight 9 leave a surface of cameras. On it each
// further feature of weight 1, and each further pin of one of its points that all views see, is a
// divisor; the degree of a product of two is their intersection number. So the matrix of these
// numbers has at most one positive eigenvalue (proofs/results/hodge.md).
#pragma once

#include "tests/laws/degree_form.h"

namespace laws {

/// The intersection numbers of the divisors on one surface; symmetric.
struct IntersectionMatrix {
    Product surface{};                                 ///< features of weight 9
    std::size_t divisors = 0;                          ///< how many
    std::vector<std::int64_t> entries;                 ///< row by row
    std::vector<std::optional<std::size_t>> members{}; ///< the class of each entry, if it has one
    std::vector<std::size_t> classes{};                ///< those whose degrees occur, ascending
};

/// The matrices that are not 0, one of each set that relabeling the views permutes.
std::vector<IntersectionMatrix> intersection_matrices(const DegreeForm& form);

/// How many eigenvalues are positive, exactly: how often the coefficients of the characteristic
/// polynomial change their sign, by Descartes, as all eigenvalues of a symmetric matrix are real.
std::size_t positive_eigenvalues(const IntersectionMatrix& matrix);

/// Between which numbers the inequalities (AB)^2 >= (AA) (BB) put the degree of a class.
struct HodgeBounds {
    std::int64_t least = 0;
    std::optional<std::int64_t> most{};
};

/// The bounds of each class if all other degrees are right.
std::vector<HodgeBounds> bounds_by_others(const std::vector<IntersectionMatrix>& matrices,
                                          const DegreeForm& form);

/// How many classes get an upper bound from those whose degrees are known to be exact, directly or
/// by way of others; the degrees on file serve as lower bounds.
std::size_t bounded_by_exact(const std::vector<IntersectionMatrix>& matrices,
                             const std::vector<bool>& exact);

} // namespace laws
