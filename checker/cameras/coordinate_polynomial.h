// Polynomials with integer coefficients in the coordinates of a camera: so a kind of cameras says
// what a matrix is at any numbers, and how it changes with each.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace checker {
struct CoordinatePolynomial {
    /// The numbers of the coordinates that are multiplied, ascending.
    using Factors = std::vector<std::size_t>;
    std::map<Factors, int> terms{}; // coefficients

    static CoordinatePolynomial constant(int value) { return {{{Factors{}, value}}}; }
    static CoordinatePolynomial coordinate(std::size_t k) { return {{{Factors{k}, 1}}}; }
};

inline CoordinatePolynomial operator+(CoordinatePolynomial a, const CoordinatePolynomial& b) {
    for (const auto& [factors, coefficient] : b.terms)
        a.terms[factors] += coefficient;
    return a;
}

inline CoordinatePolynomial operator*(const CoordinatePolynomial& a,
                                      const CoordinatePolynomial& b) {
    CoordinatePolynomial product;
    for (const auto& [x, coefficient] : a.terms)
        for (const auto& [y, other] : b.terms) {
            CoordinatePolynomial::Factors factors = x;
            factors.insert(factors.end(), y.begin(), y.end());
            std::ranges::sort(factors);
            product.terms[factors] += coefficient * other;
        }
    return product;
}

inline CoordinatePolynomial operator-(const CoordinatePolynomial& a,
                                      const CoordinatePolynomial& b) {
    return a + CoordinatePolynomial::constant(-1) * b;
}

/// The derivative by the k-th coordinate; without terms if there is none.
inline CoordinatePolynomial derivative(const CoordinatePolynomial& a, std::size_t k) {
    CoordinatePolynomial result;
    for (const auto& [factors, coefficient] : a.terms) {
        const auto power = static_cast<int>(std::ranges::count(factors, k));
        if (power == 0) continue;
        CoordinatePolynomial::Factors rest = factors;
        rest.erase(std::ranges::find(rest, k));
        result.terms[rest] += power * coefficient;
    }
    return result;
}

/// The value where the coordinates are these, numbers of a ring T.
template <class T> T value_at(const T* coordinates, const CoordinatePolynomial& a) {
    T sum(0);
    for (const auto& [factors, coefficient] : a.terms) {
        T product(coefficient);
        for (const std::size_t k : factors)
            product = product * coordinates[k];
        sum = sum + product;
    }
    return sum;
}
} // namespace checker
