// Polynomials in the numbers alpha_{v,c} of five views v and three columns c, modulo q = 2^61 - 1:
// for Lemma V12 of proofs/stars_in_several_views.md.
#pragma once

#include "proofs/computations/residue_matrices.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace proofs {

/// The exponents of alpha_{v,c}, at place 3 v + c.
using Exponents = std::array<std::uint8_t, 15>;
using SparsePolynomial = std::map<Exponents, Residue>;

/// The degree in each of the five views, then that in each of the three columns.
using Multidegree = std::array<int, 8>;

inline Multidegree multidegree(const Exponents& monomial) {
    Multidegree degree{};
    for (std::size_t n = 0; n < monomial.size(); ++n) {
        degree[n / 3] += monomial[n];
        degree[5 + n % 3] += monomial[n];
    }
    return degree;
}

inline Multidegree difference(const Multidegree& a, const Multidegree& b) {
    Multidegree result{};
    for (std::size_t n = 0; n < result.size(); ++n)
        result[n] = a[n] - b[n];
    return result;
}

inline Exponents product(const Exponents& a, const Exponents& b) {
    Exponents result{};
    for (std::size_t n = 0; n < result.size(); ++n)
        result[n] = static_cast<std::uint8_t>(a[n] + b[n]);
    return result;
}

/// At a point whose numbers are all given, alpha_{v,c} at place 3 v + c.
inline Residue value(const Exponents& monomial, const ResidueRow& alpha) {
    Residue result{1};
    for (std::size_t n = 0; n < monomial.size(); ++n)
        for (int power = 0; power < monomial[n]; ++power)
            result = result * alpha[n];
    return result;
}

inline void add_term(SparsePolynomial& polynomial, const Exponents& monomial, Residue coefficient) {
    const auto place = polynomial.emplace(monomial, Residue{}).first;
    place->second = place->second + coefficient;
    if (place->second == Residue{}) polynomial.erase(place);
}

/// Adds a product of two polynomials and a number to a third.
inline void add_product(SparsePolynomial& sum, const SparsePolynomial& a, const SparsePolynomial& b,
                        Residue factor) {
    for (const auto& [monomial, coefficient] : a)
        for (const auto& [other, times] : b)
            add_term(sum, product(monomial, other), coefficient * times * factor);
}

using PolynomialMatrix = std::vector<std::vector<SparsePolynomial>>;

inline PolynomialMatrix without_row(PolynomialMatrix matrix, std::size_t row) {
    matrix.erase(matrix.begin() + static_cast<std::ptrdiff_t>(row));
    return matrix;
}

inline PolynomialMatrix without_column(PolynomialMatrix matrix, std::size_t column) {
    for (auto& row : matrix)
        row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
    return matrix;
}

/// By the first column.
inline SparsePolynomial determinant_of(const PolynomialMatrix& matrix) {
    if (matrix.empty()) return {{Exponents{}, Residue{1}}};
    SparsePolynomial result;
    const PolynomialMatrix rest = without_column(matrix, 0);
    for (std::size_t row = 0; row < matrix.size(); ++row)
        add_product(result, matrix[row][0], determinant_of(without_row(rest, row)),
                    row % 2 == 0 ? Residue{1} : -Residue{1});
    return result;
}

/// All monomials of a multidegree, by their exponents in this view and the later ones.
inline void append_monomials(const Multidegree& left, std::size_t view, Exponents& monomial,
                             std::vector<Exponents>& result) {
    if (view == 5) {
        if (left[5] == 0 && left[6] == 0 && left[7] == 0) result.push_back(monomial);
        return;
    }
    for (int i = 0; i <= left[view] && i <= left[5]; ++i) {
        for (int j = 0; i + j <= left[view] && j <= left[6]; ++j) {
            const int k = left[view] - i - j;
            if (k > left[7]) continue;
            monomial[3 * view] = static_cast<std::uint8_t>(i);
            monomial[3 * view + 1] = static_cast<std::uint8_t>(j);
            monomial[3 * view + 2] = static_cast<std::uint8_t>(k);
            Multidegree rest = left;
            rest[5] -= i;
            rest[6] -= j;
            rest[7] -= k;
            append_monomials(rest, view + 1, monomial, result);
        }
    }
}

inline std::vector<Exponents> monomials_of(const Multidegree& degree) {
    std::vector<Exponents> result;
    for (const int d : degree)
        if (d < 0) return result;
    Exponents monomial{};
    append_monomials(degree, 0, monomial, result);
    return result;
}

/// A space of rows that grows, in echelon form.
class RowSpace {
public:
    std::size_t dimension() const { return rows_.size(); }

    /// The rest of a row, with 0 at the leading places of the rows so far.
    ResidueRow reduced(ResidueRow row) const {
        for (const auto& [place, leader] : rows_) {
            if (row[place] == Residue{}) continue;
            const Residue factor = -row[place];
            for (std::size_t n = place; n < row.size(); ++n) // the leader is 0 before
                row[n] = row[n] + factor * leader[n];
        }
        return row;
    }

    void insert(const ResidueRow& row) {
        ResidueRow rest = reduced(row);
        for (std::size_t place = 0; place < rest.size(); ++place) {
            if (rest[place] == Residue{}) continue;
            const Residue inverse = rest[place].inverse();
            for (Residue& number : rest)
                number = number * inverse;
            rows_.emplace(place, rest);
            return;
        }
    }

    bool leads(std::size_t place) const { return rows_.count(place) != 0; }

private:
    std::map<std::size_t, ResidueRow> rows_{}; // by leading places
};

} // namespace proofs
