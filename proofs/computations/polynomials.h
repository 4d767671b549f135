// Polynomials in one variable, and determinants of small matrices, modulo the prime 2^61 - 1.
#pragma once

#include "checker/algebra/modular.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace proofs {

using checker::Residue;

/// Coefficients, from the constant term on.
struct Polynomial {
    std::vector<Residue> coefficients;

    Polynomial() = default;
    Polynomial(Residue constant) : coefficients{constant} {} // numbers are polynomials
    explicit Polynomial(std::vector<Residue> all) : coefficients(std::move(all)) {}

    Residue operator[](std::size_t power) const {
        return power < coefficients.size() ? coefficients[power] : Residue{};
    }
};

inline Polynomial operator+(const Polynomial& a, const Polynomial& b) {
    Polynomial sum = a;
    sum.coefficients.resize(std::max(a.coefficients.size(), b.coefficients.size()));
    for (std::size_t i = 0; i < b.coefficients.size(); ++i)
        sum.coefficients[i] = sum.coefficients[i] + b.coefficients[i];
    return sum;
}

inline Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial product;
    if (a.coefficients.empty() || b.coefficients.empty()) return product;
    product.coefficients.resize(a.coefficients.size() + b.coefficients.size() - 1);
    for (std::size_t i = 0; i < a.coefficients.size(); ++i)
        for (std::size_t j = 0; j < b.coefficients.size(); ++j)
            product.coefficients[i + j] =
                product.coefficients[i + j] + a.coefficients[i] * b.coefficients[j];
    return product;
}

inline Polynomial operator-(const Polynomial& a, const Polynomial& b) {
    return a + Polynomial(-Residue{1}) * b;
}

/// By the first row: for matrices of size five or less.
template <class Entry>
Entry laplace(const std::vector<std::vector<Entry>>& m) {
    if (m.size() == 1) return m[0][0];
    Entry sum{};
    for (std::size_t c = 0; c < m.size(); ++c) {
        std::vector<std::vector<Entry>> rest(m.begin() + 1, m.end());
        for (auto& row : rest)
            row.erase(row.begin() + static_cast<std::ptrdiff_t>(c));
        const Entry term = m[0][c] * laplace(rest);
        sum = c % 2 == 0 ? sum + term : sum - term;
    }
    return sum;
}

/// The resultant of two forms in two variables of this degree: 0 if and only if they have a common
/// zero, also at infinity.
inline Residue resultant(const Polynomial& f, const Polynomial& g, std::size_t degree) {
    std::vector<std::vector<Residue>> sylvester(2 * degree, std::vector<Residue>(2 * degree));
    for (std::size_t shift = 0; shift < degree; ++shift)
        for (std::size_t i = 0; i <= degree; ++i) {
            sylvester[shift][shift + i] = f[i];
            sylvester[degree + shift][shift + i] = g[i];
        }
    return checker::determinant(sylvester);
}

inline Polynomial trimmed(Polynomial f) {
    while (!f.coefficients.empty() && f.coefficients.back() == Residue{})
        f.coefficients.pop_back();
    return f;
}

inline std::size_t degree(const Polynomial& f) {
    return trimmed(f).coefficients.size() - 1; // of f other than 0
}

inline Polynomial remainder(Polynomial f, const Polynomial& g) {
    const std::size_t d = degree(g);
    const Residue inverse = g[d].inverse();
    for (f = trimmed(f); f.coefficients.size() > d; f = trimmed(f)) {
        const std::size_t top = f.coefficients.size() - 1;
        Polynomial term(std::vector<Residue>(top - d + 1));
        term.coefficients.back() = f[top] * inverse;
        f = f - term * g;
        f.coefficients.resize(top);
    }
    return f;
}

inline Polynomial gcd(Polynomial f, Polynomial g) {
    while (!trimmed(g).coefficients.empty()) {
        const Polynomial rest = remainder(f, g);
        f = trimmed(g);
        g = rest;
    }
    return f;
}

inline bool has_simple_roots(const Polynomial& f) {
    Polynomial derivative;
    for (std::size_t i = 1; i <= degree(f); ++i)
        derivative.coefficients.push_back(Residue{i} * f[i]);
    return degree(gcd(f, derivative)) == 0;
}

inline Residue value(const Polynomial& f, Residue x) {
    Residue sum;
    for (std::size_t i = f.coefficients.size(); i-- > 0;)
        sum = sum * x + f[i];
    return sum;
}

/// The polynomial of this degree with the values of a function (Newton).
inline Polynomial interpolate(std::size_t degree, const std::function<Residue(Residue)>& function) {
    Polynomial result, product(Residue{1});
    for (std::size_t i = 2; i <= degree + 2; ++i) {
        const Residue x{i};
        const Residue factor = (function(x) - value(result, x)) * value(product, x).inverse();
        result = result + Polynomial(factor) * product;
        product = product * Polynomial(std::vector{-x, Residue{1}});
    }
    return result;
}

} // namespace proofs
