// The matrix N and the curves F_v of section 8 of proofs/collinear_points_curves.md, modulo the
// prime 2^61 - 1: three pins of X_3, three of X_2 and a free line in four views.
#pragma once

#include "proofs/computations/collinear_scene.h"
#include "proofs/computations/scroll_quadrics.h"
#include "proofs/computations/star_equations.h"

#include <array>
#include <vector>

namespace proofs {

/// What a view shows of the pins 1, 2, 3 of X_3 and 4, 5, 6 of X_2.
struct ThreePinImage {
    std::array<Residue, 3> t;
    Residue beta;
    std::array<Residue, 3> gamma;
};

inline ThreePinImage three_pin_image(const Pair& a, const std::array<Residue, 6>& t) {
    ThreePinImage y{{t[0], t[1], t[2]}, {}, {}};
    for (std::size_t j = 0; j < 3; ++j) {
        const Pair other = other_pin(a, 1, t[3 + j]);
        y.beta = other[0];
        y.gamma[j] = other[1];
    }
    return y;
}

/// The unknowns are s_1, s_2, sigma, the zeta_v, s_4, s_5.
inline Matrix equations(const std::vector<ThreePinImage>& views, const Pair& x) {
    Matrix rows;
    for (std::size_t v = 0; v < views.size(); ++v)
        for (std::size_t j = 0; j < 2; ++j) {
            const auto& [t, beta, gamma] = views[v];
            const Residue first = x[j] * (beta * t[0] + gamma[j]), second = beta * t[1] + gamma[j];
            Vector row(9);
            row[0] = -(beta * x[j]);
            row[1] = -beta;
            row[2] = first * (t[0] - t[2]).inverse();
            row[3 + v] = first * (t[1] - t[2]) + second * (t[2] - t[0]);
            row[7 + j] = Residue{1};
            rows.push_back(row);
        }
    return rows;
}

/// The determinant without one column: a coordinate of the vector k, up to sign.
inline Residue minor_without(Matrix rows, std::size_t column) {
    for (Vector& row : rows)
        row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
    return checker::determinant(rows);
}

/// beta alpha + gamma c for pin 6, in each view, for a vector of unknowns.
inline std::vector<Pair> last_pin(const std::vector<ThreePinImage>& views, const Vector& k) {
    std::vector<Pair> all;
    for (std::size_t v = 0; v < views.size(); ++v) {
        const auto& [t, beta, gamma] = views[v];
        const Pair c{k[2] * (t[0] - t[2]).inverse() + k[3 + v] * (t[1] - t[2]),
                     k[3 + v] * (t[2] - t[0])};
        all.push_back({beta * (t[0] * c[0] - k[0]) + gamma[2] * c[0],
                       beta * (t[1] * c[1] - k[1]) + gamma[2] * c[1]});
    }
    return all;
}

/// The values of F_1, ..., F_4. The kernel has to be of dimension 1, and not to vanish at s_5.
inline std::array<Residue, 4> three_pin_curves(const std::vector<ThreePinImage>& views,
                                               const Pair& x) {
    const Matrix rows = equations(views, x);
    const Residue scale = minor_without(rows, 8);
    const auto pin = last_pin(views, kernel_of(rows, 9).at(0));
    const Residue inverse = (x[1] - x[0]).inverse();
    std::array<Residue, 4> values;
    for (std::size_t n = 0; n < 4; ++n) {
        Matrix three;
        for (std::size_t v = 0; v < 4; ++v)
            if (v != n) three.push_back({Residue{1}, pin[v][0], pin[v][1]});
        values[n] = checker::determinant(three) * scale * scale * inverse;
    }
    return values;
}

/// The resultant, in x_5, of two random combinations of the first seven coordinates of k: a form of
/// degree 18.
inline Polynomial eliminant(const std::vector<ThreePinImage>& views, Numbers& random) {
    Matrix factors(2, Vector(7));
    for (Vector& row : factors)
        for (Residue& factor : row)
            factor = random();
    const auto combination = [&](const Pair& x, const Vector& row) {
        const Matrix rows = equations(views, x);
        Residue sum;
        for (std::size_t c = 0; c < row.size(); ++c)
            sum = sum + row[c] * minor_without(rows, c);
        return sum;
    };
    return interpolate(18, [&](Residue x) {
        const auto form = [&](const Vector& row) {
            return interpolate(3, [&](Residue y) { return combination({x, y}, row); });
        };
        return resultant(form(factors[0]), form(factors[1]), 3);
    });
}

/// The point R_v: where b_4 and b_5 of this view are 0.
inline Pair zero_of_view(const ThreePinImage& y) {
    const auto& [t, beta, gamma] = y;
    Pair x;
    for (std::size_t j = 0; j < 2; ++j)
        x[j] = (beta * t[1] + gamma[j]) * (t[0] - t[2]) *
               ((beta * t[0] + gamma[j]) * (t[1] - t[2])).inverse();
    return x;
}

/// All x^i y^j with i and j at most these.
inline Vector box_monomials(const Pair& x, std::size_t first, std::size_t second) {
    Vector all;
    Residue power{1};
    for (std::size_t i = 0; i <= first; ++i, power = power * x[0]) {
        Residue term = power;
        for (std::size_t j = 0; j <= second; ++j, term = term * x[1])
            all.push_back(term);
    }
    return all;
}

/// The rank of all multiples of the F_v of bidegree (degree, degree), together with all multiples
/// of a random linear form in coordinate `linear`, if it is 0 or 1; by values at random points.
inline std::size_t rank_with(const std::vector<ThreePinImage>& views, std::size_t degree,
                             std::size_t linear, Numbers& random) {
    const Residue zero = random(); // of the linear form
    Matrix rows;
    for (std::size_t n = 0; n < (degree + 1) * (degree + 1); ++n) {
        const Pair x = random.pair();
        rows.emplace_back();
        if (linear < 2)
            for (const Residue term :
                 box_monomials(x, degree - (linear == 0), degree - (linear == 1)))
                rows.back().push_back((x[linear] - zero) * term);
        const auto values = three_pin_curves(views, x);
        for (const Residue factor : box_monomials(x, degree - 5, degree - 5))
            for (const Residue value : values)
                rows.back().push_back(factor * value);
    }
    return rank(rows);
}

} // namespace proofs
