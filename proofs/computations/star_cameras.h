// Integrals for Theorem N (proofs/five_pins.md, section 6): over the bundle N of spaces of scenes,
// on the surface M_5 of triples of one-dimensional cameras that see five lines of a star.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <vector>

namespace proofs::star {

/// A class on M_5: a number, multiples of tau, h_2 and h_3, and a number of points.
struct ClassOnSurface {
    std::int64_t number = 0;
    std::array<std::int64_t, 3> divisor{};
    std::int64_t points = 0;
};

inline constexpr ClassOnSurface unit{1, {}, 0};
inline constexpr ClassOnSurface tau{0, {1, 0, 0}, 0};
/// The classes of the line bundles of the three views; the first is trivial.
inline constexpr std::array<ClassOnSurface, 3> of_view{{{}, {0, {0, 1, 0}, 0}, {0, {0, 0, 1}, 0}}};

inline ClassOnSurface operator+(const ClassOnSurface& x, const ClassOnSurface& y) {
    ClassOnSurface sum{x.number + y.number, {}, x.points + y.points};
    for (std::size_t i = 0; i < 3; ++i)
        sum.divisor[i] = x.divisor[i] + y.divisor[i];
    return sum;
}

/// By Lemma N8.
inline ClassOnSurface operator*(const ClassOnSurface& x, const ClassOnSurface& y) {
    constexpr int meet[3][3] = {{2, 0, 0}, {0, -2, -1}, {0, -1, -2}};
    ClassOnSurface product{x.number * y.number, {}, x.number * y.points + x.points * y.number};
    for (std::size_t i = 0; i < 3; ++i) {
        product.divisor[i] = x.number * y.divisor[i] + x.divisor[i] * y.number;
        for (std::size_t j = 0; j < 3; ++j)
            product.points += x.divisor[i] * y.divisor[j] * meet[i][j];
    }
    return product;
}

inline ClassOnSurface operator-(const ClassOnSurface& x) {
    return ClassOnSurface{-1, {}, 0} * x;
}

/// The inverse of a class whose number is 1.
inline ClassOnSurface inverse(const ClassOnSurface& x) {
    const ClassOnSurface rest{0, x.divisor, x.points};
    return unit + -rest + rest * rest;
}

/// The part of this degree.
inline ClassOnSurface part(const ClassOnSurface& x, std::size_t degree) {
    if (degree == 0) return {x.number, {}, 0};
    if (degree == 1) return {0, x.divisor, 0};
    return {0, {}, x.points};
}

/// c_1 of Q, and the Chern classes of H and of its dual.
inline const ClassOnSurface q = -tau + of_view[1] + of_view[2];
inline const ClassOnSurface chern = (unit + q) * (unit + of_view[1]) * (unit + of_view[2]);
inline const ClassOnSurface chern_of_dual{chern.number, (-chern).divisor, chern.points};

/// The exponents of a, b and zeta.
using Exponents = std::array<unsigned, 3>;
enum Variable : std::size_t { a, b, zeta };

/// A polynomial with classes on the surface as coefficients.
using Polynomial = std::map<Exponents, ClassOnSurface>;

inline Polynomial constant(const ClassOnSurface& x) {
    return {{{0, 0, 0}, x}};
}

inline Polynomial variable(Variable which) {
    Exponents exponents{};
    exponents[which] = 1;
    return {{exponents, unit}};
}

inline Polynomial operator+(Polynomial f, const Polynomial& g) {
    for (const auto& [exponents, coefficient] : g)
        f[exponents] = f[exponents] + coefficient;
    return f;
}

inline Polynomial operator*(const Polynomial& f, const Polynomial& g) {
    Polynomial product;
    for (const auto& [m, x] : f) {
        for (const auto& [n, y] : g) {
            ClassOnSurface& sum = product[{m[a] + n[a], m[b] + n[b], m[zeta] + n[zeta]}];
            sum = sum + x * y;
        }
    }
    return product;
}

inline Polynomial operator-(const Polynomial& f) {
    return constant(-unit) * f;
}

/// Replaces the power 5 + i of the variable by the i-th part of the Segre class.
inline Polynomial integral(const Polynomial& f, Variable which, const ClassOnSurface& segre) {
    Polynomial result;
    for (const auto& [exponents, coefficient] : f) {
        if (exponents[which] < 5 || exponents[which] > 7) continue;
        Exponents rest = exponents;
        rest[which] = 0;
        result[rest] = result[rest] + coefficient * part(segre, exponents[which] - 5);
    }
    return result;
}

/// c_1^2 - c_2 of U - Q, with c(U) = (1 + a)(1 + b) and c(Q) = 1 + q.
inline Polynomial class_of_free_line() {
    const Polynomial sum = variable(a) + variable(b);
    const Polynomial c1 = sum + constant(-q);
    const Polynomial c2 = variable(a) * variable(b) + -sum * constant(q) + constant(q * q);
    return c1 * c1 + -c2;
}

inline Polynomial class_of_point(unsigned pins) {
    const Polynomial z = variable(zeta);
    Polynomial product = (variable(a) + z) * (variable(b) + z);
    for (const ClassOnSurface& h : of_view)
        product = product * (constant(h) + z) * (constant(h) + z);
    // h - c_1(V) - zeta, with c_1(V) = c_1(H) - a - b and c_1(H) = q + h.
    const Polynomial pin = constant(-q) + variable(a) + variable(b) + -z;
    for (unsigned i = 0; i < pins; ++i)
        product = product * pin;
    return integral(product, zeta, inverse(chern));
}

/// A point with the most pins, five at least, the pins of the other points, and free lines.
struct ManyPins {
    unsigned pins = 0;
    std::vector<unsigned> others;
    unsigned lines = 0;
};

/// The integral of section 6 for a balanced problem. Throws std::invalid_argument if the first
/// point has fewer than five pins.
inline std::int64_t zeros(const ManyPins& problem) {
    if (problem.pins < 5) throw std::invalid_argument("The first point needs five pins.");
    Polynomial product = constant(unit);
    for (unsigned i = 5; i < problem.pins; ++i)
        product = product * constant(tau);
    for (const unsigned pins : problem.others)
        product = product * class_of_point(pins);
    for (unsigned i = 0; i < problem.lines; ++i)
        product = product * class_of_free_line();
    const Polynomial difference = variable(a) + -variable(b);
    product = product * -difference * difference;
    const ClassOnSurface segre = inverse(chern_of_dual);
    const std::int64_t twice = integral(integral(product, a, segre), b, segre)[{0, 0, 0}].points;
    if (twice % 2 != 0) throw std::logic_error("Martin's theorem gives an even number.");
    return twice / 2;
}

} // namespace proofs::star
