// Intersection numbers on (P^1)^3 x B, B the plane blown up in its three coordinate points, for
// Proposition U18 (a) of proofs/two_points.md.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <vector>

namespace proofs {

/// A class on B: a number, multiples of delta, delta' and eta, and a number of points.
struct ClassOnB {
    int number = 0;
    std::array<int, 3> divisor{};
    int points = 0;
};

/// A class on (P^1)^3 x B: its coefficient, a class on B, at each product of different h_v. Bit v
/// of the index says whether h_v is in the product.
using Class = std::array<ClassOnB, 8>;

inline ClassOnB operator*(const ClassOnB& a, const ClassOnB& b) {
    // The products of delta, delta' and eta.
    constexpr int meet[3][3] = {{1, 2, 1}, {2, 1, 1}, {1, 1, 0}};
    ClassOnB product;
    product.number = a.number * b.number;
    product.points = a.number * b.points + a.points * b.number;
    for (std::size_t i = 0; i < 3; ++i) {
        product.divisor[i] = a.number * b.divisor[i] + a.divisor[i] * b.number;
        for (std::size_t j = 0; j < 3; ++j)
            product.points += a.divisor[i] * b.divisor[j] * meet[i][j];
    }
    return product;
}

inline Class operator*(const Class& a, const Class& b) {
    Class product{};
    for (std::size_t n = 0; n < 8; ++n) {
        for (std::size_t m = 0; m < 8; ++m) {
            if ((n & m) != 0) continue; // h_v h_v = 0
            const ClassOnB term = a[n] * b[m];
            ClassOnB& sum = product[n | m];
            sum.number += term.number;
            sum.points += term.points;
            for (std::size_t i = 0; i < 3; ++i)
                sum.divisor[i] += term.divisor[i];
        }
    }
    return product;
}

/// The part of this degree.
inline Class part(const Class& all, int degree) {
    Class result{};
    for (std::size_t n = 0; n < 8; ++n) {
        const int rest = degree - std::popcount(n);
        if (rest == 0) result[n].number = all[n].number;
        if (rest == 1) result[n].divisor = all[n].divisor;
        if (rest == 2) result[n].points = all[n].points;
    }
    return result;
}

/// The summands O(D) and O(D') of the bundle N, by their classes on B.
using Twists = std::array<std::array<int, 3>, 2>;
inline constexpr Twists delta_and_delta{{{1, 0, 0}, {0, 1, 0}}}; // delta, delta'
inline constexpr Twists eta_twice{{{0, 0, 1}, {0, 0, 1}}};

/// c(N - F) in the degree in which planes of these views have a relation. N has this many trivial
/// summands besides the twisted ones, F is the sum of O(-2 h_v) over the planes.
inline Class relation(const std::vector<std::size_t>& views, int trivial, const Twists& twists) {
    Class total{};
    total[0].number = 1;
    for (const auto& twist : twists) { // 1 + twist
        Class factor{};
        factor[0] = {1, twist, 0};
        total = total * factor;
    }
    for (const std::size_t view : views) { // 1 / (1 - 2 h_v) = 1 + 2 h_v
        Class factor{};
        factor[0].number = 1;
        factor[std::size_t{1} << view].number = 2;
        total = total * factor;
    }
    const int rank = trivial + 2;
    const int planes = static_cast<int>(views.size());
    return part(total, rank - planes + 1);
}

/// The intersection numbers for two free lines and a third condition.
struct IntersectionNumbers {
    int pin, seen_by_two, seen_by_one;
};

inline IntersectionNumbers intersection_numbers() {
    const Class line = relation({0, 1, 2}, 2, delta_and_delta);
    const Class pin = relation({0, 1, 2}, 1, delta_and_delta);
    const Class seen_by_two = relation({1, 1, 2, 2}, 2, eta_twice);
    const Class seen_by_one = relation({0, 0, 1, 2}, 2, delta_and_delta);
    const auto number = [&](const Class& third) { return (line * line * third)[7].points; };
    return {number(pin), number(seen_by_two), number(seen_by_one)};
}

} // namespace proofs
