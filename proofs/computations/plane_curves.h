// The curves of degree 7 of section 7 of proofs/collinear_points_curves.md, modulo the prime
// 2^61 - 1, and how many conditions their multiples leave.
#pragma once

#include "proofs/computations/collinear_scene.h"
#include "proofs/computations/scroll_quadrics.h"

#include <array>
#include <vector>

namespace proofs {

/// What a view shows of the pins: 0 to 3 of X_3, 4 to 6 of X_2, 7 of X_1.
using EightImages = std::array<Residue, 8>;

/// The classes of e_0, ..., e_3 modulo O = (o, 1): e_0, e_1, e_2 is a basis, and the sum is 0.
inline std::array<Pair, 4> frame(const Pair& o) {
    const Residue zero{}, one{1};
    return {Pair{one, zero}, Pair{zero, one}, Pair{-o[0], -o[1]}, Pair{o[0] - one, o[1] - one}};
}

/// The class of t_v.
inline Pair ray(const EightImages& t, const Pair& o) {
    const Residue last = t[2] - t[3];
    return {t[0] - t[3] - o[0] * last, t[1] - t[3] - o[1] * last};
}

/// The conditions of the views on (y_0, y_1, y_2, a_4, a_5): maps a with a(e_j) = y_j w_j, y_3 = 0.
inline Matrix conditions(const std::vector<EightImages>& views, const Pair& o) {
    const auto w = frame(o);
    Matrix rows;
    for (const EightImages& t : views) {
        const Pair q = ray(t, o);
        rows.emplace_back();
        for (std::size_t j = 0; j < 3; ++j)
            rows.back().push_back((t[j] - t[6] - t[7]) * area(q, w[j]));
        for (const std::size_t j : {std::size_t{4}, std::size_t{5}}) {
            rows.back().push_back((t[j] - t[6]) * -q[1]);
            rows.back().push_back((t[j] - t[6]) * q[0]);
        }
    }
    return rows;
}

/// a(e_4), ..., a(e_7).
inline std::array<Pair, 4> values(const Vector& a, const Pair& o) {
    const auto w = frame(o);
    Pair last{}, third{};
    for (std::size_t n = 0; n < 2; ++n) {
        for (std::size_t j = 0; j < 3; ++j)
            last[n] = last[n] - a[j] * w[j][n];
        third[n] = last[n] - a[3 + n] - a[5 + n];
    }
    return {Pair{a[3], a[4]}, Pair{a[5], a[6]}, third, last};
}

/// The forms omega_4, ..., omega_7 on the kernel of the conditions, which has to have dimension 3:
/// a row each.
inline Matrix two_forms(const Matrix& basis, const Pair& o) {
    Matrix forms(4, Vector(3));
    for (std::size_t i = 0; i < 3; ++i) {
        const auto a = values(basis[(i + 1) % 3], o), b = values(basis[(i + 2) % 3], o);
        for (std::size_t j = 0; j < 4; ++j)
            forms[j][i] = area(a[j], b[j]);
    }
    return forms;
}

/// The values at O = (o, 1) of the four curves; curve n leaves out omega_{4 + n}. They are
/// determinants of three of the forms, times the square of the minor of the conditions that
/// belongs to the basis of the kernel.
inline std::array<Residue, 4> curves_at(const std::vector<EightImages>& views, const Pair& o) {
    const Matrix rows = conditions(views, o);
    const Matrix basis = kernel_of(rows, 7);
    // The basis is the identity at the columns from 4 on, if the minor of the others is not 0.
    Matrix minor = rows;
    for (Vector& row : minor)
        row.resize(4);
    const Residue scale = checker::determinant(minor);
    const Matrix forms = two_forms(basis, o);
    std::array<Residue, 4> values;
    for (std::size_t n = 0; n < 4; ++n) {
        Matrix three = forms;
        three.erase(three.begin() + static_cast<std::ptrdiff_t>(n));
        values[n] = checker::determinant(three) * scale * scale;
    }
    return values;
}

/// The point O of a scene with eight pins, in this order.
inline Pair center_of(const std::vector<Pin>& pins) {
    const Matrix coordinates = kernel_of(rows_of_H(pins), 8); // u_j is column j
    Matrix others;
    for (std::size_t j = 4; j < 8; ++j)
        others.push_back({coordinates[0][j], coordinates[1][j], coordinates[2][j]});
    const Vector form = kernel_of(others, 3).at(0); // on U; 0 on the u_j of X_1 and X_2
    Matrix projected(2);
    for (std::size_t j = 0; j < 4; ++j) {
        Residue factor;
        for (std::size_t i = 0; i < 3; ++i)
            factor = factor + form[i] * coordinates[i][j];
        for (std::size_t n = 0; n < 2; ++n)
            projected[n].push_back(factor * pins[j].w[n]);
    }
    for (const Vector& o : kernel_of(projected, 4)) { // one of them is no multiple of (1, 1, 1, 1)
        if (o[2] == o[3]) continue;
        const Residue inverse = (o[2] - o[3]).inverse();
        return {(o[0] - o[3]) * inverse, (o[1] - o[3]) * inverse};
    }
    return {};
}

/// Four pins of X_3, three of X_2, one of X_1.
inline std::vector<Pin> eight_pins(Numbers& random) {
    std::vector<Pin> pins;
    constexpr std::array<std::size_t, 8> points{2, 2, 2, 2, 1, 1, 1, 0};
    for (const std::size_t point : points)
        pins.push_back({point, random(), random.pair()});
    return pins;
}

/// The rank of all multiples of this degree of the four curves, by their values at random points.
inline std::size_t rank_of_multiples(const std::vector<EightImages>& views, std::size_t degree,
                                     Numbers& random) {
    const std::size_t dimension = (degree + 1) * (degree + 2) / 2;
    Matrix columns; // one for each point
    for (std::size_t n = 0; n < dimension; ++n) {
        const Pair o = random.pair();
        const auto values = curves_at(views, o);
        columns.emplace_back();
        for (const Residue factor : ternary_monomials({o[0], o[1], Residue{1}}, degree - 7))
            for (const Residue value : values)
                columns.back().push_back(factor * value);
    }
    return rank(columns);
}

} // namespace proofs
