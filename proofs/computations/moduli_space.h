// Integrals over the space M of calibrated cameras in three views, for Theorem Y of
// proofs/calibrated_moduli.md, by fixed points of a torus, modulo q = 2^61 - 1.
#pragma once

#include "checker/algebra/modular.h"
#include "proofs/computations/incident_lines.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

namespace proofs {

using checker::Residue;

/// A character of the torus of the group by which M is a quotient: its exponents for the torus of
/// SL_2, the scales of the three views, and the scale of all translations.
using Character = std::array<int, 5>;
enum Exponent : std::size_t { z, a1, a2, a3, s };

/// A coordinate of a vector of which M has the class. A larger torus multiplies each by a number of
/// its own: its weight is the character plus a shift.
struct Coordinate {
    Character character{};
    Residue shift{};
};

/// The fixed points do not change where the stability varies little.
inline constexpr Character stability{0, 10, 10, 10, 1};

/// Of each view four coordinates of a quaternion, two in each weight of SL_2, and three of a
/// translation.
inline std::vector<Coordinate> generic_coordinates(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<Coordinate> coordinates;
    const auto add = [&](const Character& character, int count) {
        for (int i = 0; i < count; ++i)
            coordinates.push_back({character, Residue::of(random())});
    };
    for (const std::size_t view : {a1, a2, a3}) {
        Character quaternion{}, translation{};
        quaternion[view] = 1;
        for (const int sign : {1, -1}) {
            quaternion[z] = sign;
            add(quaternion, 2);
        }
        translation[view] = 2;
        translation[s] = 1;
        add(translation, 3);
    }
    return coordinates;
}

/// The Chern roots of the bundle of space, and those of the bundles of the images.
struct Roots {
    std::array<Residue, 4> x{};
    std::array<Residue, 3> h{};
};

/// What a fixed point adds to an integral is the weight times the value of the integrand.
struct FixedPoint {
    Residue weight{};
    Roots roots{};
};

inline Residue residue_of(int x) {
    const Residue size{static_cast<std::uint64_t>(x < 0 ? -x : x)};
    return x < 0 ? -size : size;
}

/// The number between -q/2 and q/2.
inline std::int64_t number_of(Residue x) {
    const auto value = static_cast<std::int64_t>(x.value);
    constexpr auto q = static_cast<std::int64_t>(checker::modulus);
    return value > q / 2 ? value - q : value;
}

/// Five coordinates. At a fixed point all others are 0.
using Support = std::array<std::size_t, 5>;
using Square = std::array<std::array<Residue, 5>, 5>;

/// The matrix with these characters as rows.
inline Square matrix_of(const std::vector<Coordinate>& coordinates, const Support& support) {
    Square matrix{};
    for (std::size_t i = 0; i < 5; ++i)
        for (std::size_t j = 0; j < 5; ++j)
            matrix[i][j] = residue_of(coordinates[support[i]].character[j]);
    return matrix;
}

/// Whether the stability is a combination of the rows, which have this determinant, with positive
/// factors: by Cramer's rule. All determinants are less than 10^5, so residues show their signs.
inline bool is_stable(const Square& rows, std::int64_t determinant, const Character& stable) {
    std::int64_t least = 1;
    for (std::size_t i = 0; i < 5; ++i) {
        Square replaced = rows;
        for (std::size_t j = 0; j < 5; ++j)
            replaced[i][j] = residue_of(stable[j]);
        const std::int64_t factor = number_of(checker::determinant(replaced));
        least = std::min(least, determinant > 0 ? factor : -factor);
    }
    if (least == 0) throw std::logic_error("some points are semistable, but not stable");
    return least > 0;
}

/// Where the five coordinates have the weight 0.
inline std::array<Residue, 5> values_at(const std::vector<Coordinate>& coordinates,
                                        const Support& support, const Square& rows,
                                        Residue determinant) {
    std::array<Residue, 5> values{};
    for (std::size_t j = 0; j < 5; ++j) {
        Square replaced = rows;
        for (std::size_t i = 0; i < 5; ++i)
            replaced[i][j] = -coordinates[support[i]].shift;
        values[j] = checker::determinant(replaced) * determinant.inverse();
    }
    return values;
}

inline Residue weight_of(const Coordinate& coordinate, const std::array<Residue, 5>& values) {
    Residue weight = coordinate.shift;
    for (std::size_t j = 0; j < 5; ++j)
        weight = weight + residue_of(coordinate.character[j]) * values[j];
    return weight;
}

/// The product of the weights of all coordinates but those of the support.
inline Residue normal_weight(const std::vector<Coordinate>& coordinates, const Support& support,
                             const std::array<Residue, 5>& values) {
    Residue product{1};
    for (std::size_t i = 0; i < coordinates.size(); ++i)
        if (std::find(support.begin(), support.end(), i) == support.end())
            product = product * weight_of(coordinates[i], values);
    if (product == Residue{}) throw std::logic_error("the shifts are not generic");
    return product;
}

/// The product of the roots of SL_2 and the class of the translations of space. The order 2 of the
/// Weyl group divides, and the two elements of the group that act as the identity multiply.
inline FixedPoint fixed_point(const std::array<Residue, 5>& values, Residue order_and_normal) {
    const Residue two_z = values[z] + values[z];
    const Residue of_roots = -(two_z * two_z);
    const Residue of_translations = values[s] * (values[s] + two_z) * (values[s] - two_z);
    FixedPoint point{of_roots * of_translations * order_and_normal.inverse(), {}};
    point.roots.x = {two_z, {}, -two_z, -values[s]};
    for (std::size_t view = 0; view < 3; ++view)
        point.roots.h[view] = values[a1 + view] + values[a1 + view];
    return point;
}

/// All fixed points in M. The shifts are those of the seed.
inline std::vector<FixedPoint> fixed_points(const Character& stable = stability,
                                            std::uint64_t seed = 5) {
    const std::vector<Coordinate> coordinates = generic_coordinates(seed);
    std::vector<FixedPoint> points;
    const auto consider = [&](const Support& support) {
        const Square rows = matrix_of(coordinates, support);
        const Residue determinant = checker::determinant(rows);
        const std::int64_t number = number_of(determinant);
        if (number == 0 || !is_stable(rows, number, stable)) return;
        const auto values = values_at(coordinates, support, rows, determinant);
        const Residue order = number < 0 ? -determinant : determinant;
        points.push_back(fixed_point(values, order * normal_weight(coordinates, support, values)));
    };
    const std::size_t n = coordinates.size();
    Support support{};
    auto& [a, b, c, d, e] = support;
    for (a = 0; a < n; ++a)
        for (b = a + 1; b < n; ++b)
            for (c = b + 1; c < n; ++c)
                for (d = c + 1; d < n; ++d)
                    for (e = d + 1; e < n; ++e)
                        consider(support);
    return points;
}

/// The class of a point that all views see, with so many pins.
inline Residue class_of_point(const Roots& roots, unsigned pins) {
    const auto& [x, h] = roots;
    Residue sum;
    for (const Residue at : x) {
        Residue above{1}, below{1}, pin = h[0] + h[1] + h[2];
        for (const Residue image : h)
            above = above * (image - at) * (image - at);
        for (const Residue other : x) {
            if (other == at) continue;
            below = below * (other - at);
            pin = pin - other;
        }
        for (unsigned i = 0; i < pins; ++i)
            above = above * pin;
        sum = sum + above * below.inverse();
    }
    return sum;
}

/// Features that all views see: the pins of each point, and how many free lines.
struct VisibleFeatures {
    std::vector<unsigned> pins{};
    unsigned lines = 0;
};

/// The intersection number of their classes: the integral of the product.
inline std::int64_t intersection_number(const std::vector<FixedPoint>& points,
                                        const VisibleFeatures& features) {
    Residue sum;
    for (const auto& [weight, roots] : points) {
        Residue product = weight;
        for (const unsigned pins : features.pins)
            product = product * class_of_point(roots, pins);
        for (unsigned i = 0; i < features.lines; ++i)
            product = product * class_of_incident_line(roots.x, roots.h);
        sum = sum + product;
    }
    return number_of(sum);
}

} // namespace proofs
