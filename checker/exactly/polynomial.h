// Polynomials in one variable modulo q = 2^61 - 1, and their integrals over projective bundles. A
// bundle is given by its Chern roots, which may be the same. The variable is the class of the
// tautological line.
#pragma once

#include "checker/algebra/modular.h"

#include <algorithm>
#include <span>
#include <vector>

namespace checker::exactly {
/// Coefficients, the constant one first.
struct Polynomial {
    std::vector<Residue> at{};

    /// 0 beyond the last coefficient.
    Residue coefficient(std::size_t i) const { return i < at.size() ? at[i] : Residue{}; }
};

inline Polynomial operator+(const Polynomial& f, const Polynomial& g) {
    Polynomial sum{std::vector<Residue>(std::max(f.at.size(), g.at.size()))};
    for (std::size_t i = 0; i < sum.at.size(); ++i)
        sum.at[i] = f.coefficient(i) + g.coefficient(i);
    return sum;
}

inline Polynomial operator*(const Polynomial& f, const Polynomial& g) {
    if (f.at.empty() || g.at.empty()) return {};
    Polynomial product{std::vector<Residue>(f.at.size() + g.at.size() - 1)};
    for (std::size_t i = 0; i < f.at.size(); ++i)
        for (std::size_t j = 0; j < g.at.size(); ++j)
            product.at[i + j] = product.at[i + j] + f.at[i] * g.at[j];
    return product;
}

inline Polynomial operator-(const Polynomial& f, const Polynomial& g) {
    return f + Polynomial{{-Residue{1}}} * g;
}

inline Residue value_at(const Polynomial& f, Residue x) {
    Residue value;
    for (std::size_t i = f.at.size(); i-- > 0;)
        value = value * x + f.at[i];
    return value;
}

/// The complete symmetric polynomials of the roots, of the degrees 0 to `degree`: up to signs, the
/// Segre classes.
inline std::vector<Residue> complete_symmetric(std::span<const Residue> roots, std::size_t degree) {
    std::vector<Residue> complete(degree + 1);
    complete[0] = Residue{1};
    for (const Residue root : roots)
        for (std::size_t i = 1; i <= degree; ++i)
            complete[i] = complete[i] + root * complete[i - 1];
    return complete;
}

/// The integral over P(B) of f, as the Segre classes of B give it.
inline Residue integral_over_points(const Polynomial& f, std::span<const Residue> roots) {
    const std::vector<Residue> complete = complete_symmetric(roots, f.at.size());
    Residue sum;
    for (std::size_t i = roots.size() - 1; i < f.at.size(); ++i)
        sum = sum + f.at[i] * complete[i + 1 - roots.size()];
    return roots.size() % 2 == 1 ? sum : -sum;
}

/// The integral over P(B / X) of f, for a line X of B: a polynomial of degree 1 in the class of X.
/// The complete symmetric polynomials of B / X are those of B, less x times the previous ones.
inline Polynomial integral_over_quotient(const Polynomial& f, std::span<const Residue> roots) {
    const std::size_t rank = roots.size() - 1;
    const std::vector<Residue> complete = complete_symmetric(roots, f.at.size());
    Polynomial sum{{Residue{}, Residue{}}};
    for (std::size_t i = rank - 1; i < f.at.size(); ++i) {
        const std::size_t degree = i + 1 - rank;
        sum.at[0] = sum.at[0] + f.at[i] * complete[degree];
        if (degree > 0) sum.at[1] = sum.at[1] - f.at[i] * complete[degree - 1];
    }
    return rank % 2 == 1 ? sum : Polynomial{} - sum;
}

/// The integral of f(x) g(l) over all points X in lines of P(B), where x and l are the classes of X
/// and of the line modulo X.
inline Residue integral_over_flags(const Polynomial& f, const Polynomial& g,
                                   std::span<const Residue> roots) {
    return integral_over_points(f * integral_over_quotient(g, roots), roots);
}
} // namespace checker::exactly
