// Matrices and polynomials modulo q = 2^61 - 1, for ranks of single examples: ranks of generic ones
// are at least these.
#pragma once

#include "checker/algebra/modular.h"

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace proofs {

using checker::Residue;
using ResidueRow = std::vector<Residue>;
using ResidueMatrix = std::vector<ResidueRow>; // row by row

/// Pseudo-random residues: the same ones in each run.
class Residues {
public:
    explicit Residues(unsigned seed) : engine_(seed) {}
    Residue next() { return Residue::of(engine_()); }
    ResidueRow row(std::size_t size) {
        ResidueRow numbers(size);
        for (Residue& number : numbers)
            number = next();
        return numbers;
    }
    ResidueMatrix matrix(std::size_t rows, std::size_t columns) {
        ResidueMatrix numbers;
        for (std::size_t i = 0; i < rows; ++i)
            numbers.push_back(row(columns));
        return numbers;
    }

private:
    std::mt19937_64 engine_;
};

inline Residue product(const ResidueRow& a, const ResidueRow& b) {
    Residue sum;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum = sum + a[i] * b[i];
    return sum;
}

/// A matrix in echelon form: its rows that are not 0, and the columns of their leading ones.
struct Echelon {
    ResidueMatrix rows{};
    std::vector<std::size_t> pivots{};
};

/// Adds a multiple of one row to another, from a column on.
inline void add_multiple(ResidueRow& row, Residue factor, const ResidueRow& other,
                         std::size_t from = 0) {
    for (std::size_t j = from; j < row.size(); ++j)
        row[j] = row[j] + factor * other[j];
}

/// An echelon form: below a leading one there are zeros, above it too if it is to be reduced.
inline Echelon echelon(ResidueMatrix matrix, bool reduced = true) {
    Echelon result;
    const std::size_t columns = matrix.empty() ? 0 : matrix.front().size();
    std::size_t rank = 0;
    for (std::size_t column = 0; column < columns && rank < matrix.size(); ++column) {
        std::size_t pivot = rank;
        while (pivot < matrix.size() && matrix[pivot][column] == Residue{})
            ++pivot;
        if (pivot == matrix.size()) continue;
        std::swap(matrix[rank], matrix[pivot]);
        const Residue inverse = matrix[rank][column].inverse();
        for (Residue& number : matrix[rank])
            number = number * inverse;
        for (std::size_t i = reduced ? 0 : rank + 1; i < matrix.size(); ++i)
            if (i != rank && matrix[i][column] != Residue{})
                add_multiple(matrix[i], -matrix[i][column], matrix[rank], column);
        result.pivots.push_back(column);
        ++rank;
    }
    matrix.resize(rank);
    result.rows = std::move(matrix);
    return result;
}

inline std::size_t rank_of(const ResidueMatrix& matrix) {
    return echelon(matrix, false).pivots.size();
}

/// A basis of the vectors with this many coordinates that all rows take to 0.
inline ResidueMatrix kernel_of(const ResidueMatrix& matrix, std::size_t columns) {
    const Echelon reduced = echelon(matrix);
    std::vector<bool> leads(columns);
    for (const std::size_t pivot : reduced.pivots)
        leads[pivot] = true;
    ResidueMatrix basis;
    for (std::size_t column = 0; column < columns; ++column) {
        if (leads[column]) continue;
        ResidueRow vector(columns);
        vector[column] = {1};
        for (std::size_t i = 0; i < reduced.rows.size(); ++i)
            vector[reduced.pivots[i]] = -reduced.rows[i][column];
        basis.push_back(vector);
    }
    return basis;
}

inline Residue determinant_of(ResidueMatrix matrix) {
    Residue result{1};
    for (std::size_t column = 0; column < matrix.size(); ++column) {
        std::size_t pivot = column;
        while (pivot < matrix.size() && matrix[pivot][column] == Residue{})
            ++pivot;
        if (pivot == matrix.size()) return {};
        if (pivot != column) result = -result;
        std::swap(matrix[column], matrix[pivot]);
        result = result * matrix[column][column];
        const Residue inverse = matrix[column][column].inverse();
        for (std::size_t i = column + 1; i < matrix.size(); ++i)
            add_multiple(matrix[i], -matrix[i][column] * inverse, matrix[column]);
    }
    return result;
}

inline ResidueMatrix product(const ResidueMatrix& a, const ResidueMatrix& b) {
    ResidueMatrix result(a.size(), ResidueRow(b.front().size()));
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < b.size(); ++k)
            add_multiple(result[i], a[i][k], b[k]);
    return result;
}

/// The coefficients, from the constant one, of the polynomial with these values at 0, 1, 2, ...
inline ResidueRow interpolated(const ResidueRow& values) {
    ResidueMatrix equations;
    for (std::size_t x = 0; x < values.size(); ++x) {
        ResidueRow equation;
        Residue power{1};
        for (std::size_t n = 0; n < values.size(); ++n) {
            equation.push_back(power);
            power = power * Residue::of(x);
        }
        equation.push_back(values[x]);
        equations.push_back(equation);
    }
    ResidueRow coefficients;
    for (const ResidueRow& row : echelon(equations).rows)
        coefficients.push_back(row.back());
    return coefficients;
}

/// Whether binary forms of one degree d, given by d + 1 coefficients each, have no common zero: it
/// suffices that their products with monomials span all forms of degree 2 d.
inline bool have_no_common_zero(const ResidueMatrix& forms) {
    const std::size_t degree = forms.front().size() - 1;
    ResidueMatrix products;
    for (const ResidueRow& form : forms) {
        for (std::size_t shift = 0; shift <= degree; ++shift) {
            ResidueRow row(2 * degree + 1);
            for (std::size_t i = 0; i <= degree; ++i)
                row[i + shift] = form[i];
            products.push_back(row);
        }
    }
    return rank_of(products) == 2 * degree + 1;
}

} // namespace proofs
