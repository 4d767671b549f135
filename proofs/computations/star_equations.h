// The matrices of sections 4 and 5 of proofs/collinear_points_more_views.md, and of section 6 of
// proofs/collinear_points_curves.md. Entries are numbers or polynomials in one variable.
#pragma once

#include "proofs/computations/collinear_scene.h"
#include "proofs/computations/polynomials.h"

#include <array>
#include <vector>

namespace proofs {

/// What a view shows of four pins of X_3, and of one more feature: the numbers k, m_1 and m_2 of
/// section 4.
struct StarImage {
    std::array<Residue, 4> t;
    Residue k, m1, m2;

    Residue t_(std::size_t i, std::size_t j) const { return t[i - 1] - t[j - 1]; }
};

/// (z : 1) is the fourth pin, (sigma : sigma') the other coordinate; z is z[0] / z[1].
template <class Number>
struct StarPoint {
    std::array<Number, 2> z, sigma;
};

/// The determinant of the two equations for c: Delta.
template <class Number>
Number delta(const StarImage& y, const StarPoint<Number>& q) {
    return Number(y.t_(1, 3) * y.t_(2, 4)) * q.z[1] - Number(y.t_(2, 3) * y.t_(1, 4)) * q.z[0];
}

/// Delta times c: Y_1 and Y_2.
template <class Number>
std::array<Number, 2> scaled_c(const StarImage& y, const StarPoint<Number>& q) {
    return {Number(y.t_(2, 4)) * q.sigma[0] - Number(y.t_(2, 3)) * q.sigma[1],
            Number(y.t_(1, 3)) * q.sigma[1] * q.z[1] - Number(y.t_(1, 4)) * q.sigma[0] * q.z[0]};
}

/// A row of the matrix G of sections 4 and 5.
template <class Number>
std::vector<Number> row(const StarImage& y, const StarPoint<Number>& q) {
    const Number d = delta(y, q);
    const auto c = scaled_c(y, q);
    return {d, Number(y.k) * d, Number(y.m1) * c[0], Number(y.m2) * c[1]};
}

/// What a view shows of three pins of X_3, and of two more: section 6.
struct TwoPinImage {
    std::array<Residue, 3> t;
    std::array<Residue, 2> beta, gamma;
};

/// A row of the matrix of section 6, at the pins (x : 1) and (y : 1).
template <class Number>
std::vector<Number> row(const TwoPinImage& y, const std::array<std::array<Number, 2>, 2>& x) {
    const Residue inverse = (y.t[0] - y.t[2]).inverse();
    std::array<Number, 2> b, p;
    for (std::size_t j = 0; j < 2; ++j) {
        const Number first = Number(y.beta[j] * y.t[0] + y.gamma[j]) * x[j][0];
        const Number second = Number(y.beta[j] * y.t[1] + y.gamma[j]) * x[j][1];
        b[j] = Number(y.t[1] - y.t[2]) * first - Number(y.t[0] - y.t[2]) * second;
        p[j] = Number(inverse) * first;
    }
    return {b[1], Number(y.beta[0]) * b[1], b[0], Number(y.beta[1]) * b[0],
            p[0] * b[1] - p[1] * b[0]};
}

/// A pin of another point than X_3 that a view sees at t, with the free line at (a, -1): beta,
/// gamma.
inline Pair other_pin(const Pair& a, std::size_t point, Residue t) {
    const Pair beta = in_terms_of(a, point);
    return {beta[0], beta[1] - t};
}

/// Section 4: four pins of X_3, and one of another point.
inline StarImage with_pin(const std::array<Residue, 4>& t, const Pair& other) {
    const auto [beta, gamma] = other;
    return {t, beta, beta * t[0] + gamma, beta * t[1] + gamma};
}

/// Section 5: the fourth pin of X_3 joins it to the point P. The pin of X_2 is seen at t_5, P at
/// phi_2 = theta, and its pin on the line phi_3 + q phi_2.
inline StarImage with_point(const std::array<Residue, 4>& t, Residue t5, Residue theta, Residue q) {
    const Residue e = q * (t5 - theta);
    return {t, q, t[0] - t[3] + e, t[1] - t[3] + e};
}

} // namespace proofs
