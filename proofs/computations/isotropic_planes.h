// Lemma Y4 of proofs/calibrated_moduli.md: in how many ways two calibrated views see a plane that
// touches the absolute conic, with two points and three lines through them, modulo q = 2^61 - 1.
#pragma once

#include "checker/algebra/modular.h"

#include <array>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <vector>

namespace proofs {

using checker::Residue;
using Vector3 = std::array<Residue, 3>;
using Collineation = std::array<Residue, 9>; // a matrix of size 3, row by row

/// Coefficients, the constant one first. The last one is not 0; the polynomial 0 has none.
using Polynomial = std::vector<Residue>;

inline Polynomial trimmed(Polynomial f) {
    while (!f.empty() && f.back() == Residue{})
        f.pop_back();
    return f;
}

/// The remainder of f by g, which is not 0.
inline Polynomial remainder(Polynomial f, const Polynomial& g) {
    const Residue inverse = g.back().inverse();
    for (f = trimmed(f); f.size() >= g.size(); f = trimmed(f)) {
        const Residue factor = f.back() * inverse;
        for (std::size_t i = 0; i < g.size(); ++i)
            f[f.size() - g.size() + i] = f[f.size() - g.size() + i] - factor * g[i];
    }
    return f;
}

/// The quotient of f by g, if g divides it.
inline Polynomial quotient(Polynomial f, const Polynomial& g) {
    Polynomial result(f.size() + 1 - g.size());
    const Residue inverse = g.back().inverse();
    for (std::size_t i = result.size(); i-- > 0;) {
        result[i] = f[i + g.size() - 1] * inverse;
        for (std::size_t j = 0; j < g.size(); ++j)
            f[i + j] = f[i + j] - result[i] * g[j];
    }
    return result;
}

inline Polynomial common_divisor(Polynomial f, Polynomial g) {
    while (!g.empty()) {
        const Polynomial rest = remainder(f, g);
        f = g;
        g = rest;
    }
    return f;
}

inline Polynomial derivative(const Polynomial& f) {
    Polynomial result;
    for (std::size_t i = 1; i < f.size(); ++i)
        result.push_back(Residue{i} * f[i]);
    return trimmed(result);
}

/// The polynomial of degree less than the number of values, which are those at 0, 1, 2, ....
inline Polynomial interpolated(const std::vector<Residue>& values) {
    Polynomial sum(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        Polynomial product{values[i]};
        for (std::size_t j = 0; j < values.size(); ++j) {
            if (j == i) continue;
            const Residue factor = (Residue{i} - Residue{j}).inverse();
            Polynomial next(product.size() + 1);
            for (std::size_t k = 0; k < product.size(); ++k) {
                next[k] = next[k] - product[k] * Residue{j} * factor;
                next[k + 1] = next[k + 1] + product[k] * factor;
            }
            product = next;
        }
        for (std::size_t k = 0; k < product.size(); ++k)
            sum[k] = sum[k] + product[k];
    }
    return trimmed(sum);
}

inline Residue determinant(const Collineation& g) {
    return g[0] * (g[4] * g[8] - g[5] * g[7]) - g[1] * (g[3] * g[8] - g[5] * g[6]) +
           g[2] * (g[3] * g[7] - g[4] * g[6]);
}

/// The discriminant of the characteristic polynomial t^3 + b t^2 + c t + d of the transpose of g
/// times g.
inline Residue discriminant(const Collineation& g) {
    const auto product = [&](std::size_t i, std::size_t j) {
        return g[i] * g[j] + g[3 + i] * g[3 + j] + g[6 + i] * g[6 + j];
    };
    const auto minor = [&](std::size_t i, std::size_t j) {
        return product(i, i) * product(j, j) - product(i, j) * product(i, j);
    };
    const Residue det = determinant(g);
    const Residue b = -(product(0, 0) + product(1, 1) + product(2, 2));
    const Residue c = minor(0, 1) + minor(0, 2) + minor(1, 2);
    const Residue d = -(det * det);
    return Residue{18} * b * c * d - Residue{4} * b * b * b * d + b * b * c * c -
           Residue{4} * c * c * c - Residue{27} * d * d;
}

/// A basis of the collineations that meet seven linear equations, if these are independent.
inline std::array<Collineation, 2> pencil_of(std::vector<Collineation> equations) {
    std::vector<std::size_t> pivots;
    for (std::size_t column = 0; column < 9 && pivots.size() < equations.size(); ++column) {
        std::size_t row = pivots.size();
        while (row < equations.size() && equations[row][column] == Residue{})
            ++row;
        if (row == equations.size()) continue;
        std::swap(equations[pivots.size()], equations[row]);
        Collineation& pivot = equations[pivots.size()];
        const Residue inverse = pivot[column].inverse();
        for (Residue& entry : pivot)
            entry = entry * inverse;
        for (Collineation& other : equations) {
            if (&other == &pivot) continue;
            const Residue factor = other[column];
            for (std::size_t i = 0; i < 9; ++i)
                other[i] = other[i] - factor * pivot[i];
        }
        pivots.push_back(column);
    }
    if (pivots != std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6})
        throw std::logic_error("the images are not generic");
    std::array<Collineation, 2> pencil{};
    for (std::size_t i = 0; i < 2; ++i) {
        pencil[i][7 + i] = Residue{1};
        for (std::size_t row = 0; row < 7; ++row)
            pencil[i][row] = -equations[row][7 + i];
    }
    return pencil;
}

/// The collineations that take two points of view 2 to points of view 3, and two lines through the
/// first, and one through the second, to lines.
inline std::array<Collineation, 2> generic_pencil(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto vector = [&] {
        return Vector3{Residue::of(random()), Residue::of(random()), Residue::of(random())};
    };
    const auto join = [](const Vector3& a, const Vector3& b) {
        return Vector3{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                       a[0] * b[1] - a[1] * b[0]};
    };
    std::vector<Collineation> equations;
    const auto place_on_line = [&](const Vector3& place, const Vector3& line) {
        Collineation& equation = equations.emplace_back();
        for (std::size_t i = 0; i < 9; ++i)
            equation[i] = line[i / 3] * place[i % 3];
    };
    for (const int pins : {2, 1}) {
        const Vector3 before = vector(), after = vector();
        for (int line = 0; line < 2; ++line)
            place_on_line(before, join(after, vector()));
        for (int pin = 0; pin < pins; ++pin)
            place_on_line(vector(), join(after, vector()));
    }
    return pencil_of(equations);
}

/// At how many simple roots of the discriminant, on a generic pencil, the determinant is not 0.
inline std::size_t isotropic_planes(std::uint64_t seed = 3) {
    const std::array<Collineation, 2> pencil = generic_pencil(seed);
    std::vector<Residue> discriminants, determinants;
    for (std::size_t tau = 0; tau <= 12; ++tau) {
        Collineation g{};
        for (std::size_t i = 0; i < 9; ++i)
            g[i] = pencil[0][i] + Residue{tau} * pencil[1][i];
        discriminants.push_back(discriminant(g));
        determinants.push_back(determinant(g));
    }
    const Polynomial f = interpolated(discriminants);
    const Polynomial once = quotient(f, common_divisor(f, derivative(f))); // each root once
    const Polynomial multiple = common_divisor(once, derivative(f));
    const Polynomial simple = quotient(once, multiple);
    return simple.size() - common_divisor(simple, interpolated(determinants)).size();
}

} // namespace proofs
