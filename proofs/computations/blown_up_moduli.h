// Fixed points, modulo q = 2^61 - 1, of the tori of the three views on the blow-up of the space M
// of calibrated_moduli.md along the three loci where a camera has rank one: Theorem Z of
// proofs/blown_up_cameras.md uses them. No theorem rests on the classes of features below: section
// 9 of calibrated_moduli.md says what they suggest.
#pragma once

#include "checker/algebra/modular.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

namespace proofs::blown_up {

using checker::Residue;
using Triple = std::array<Residue, 3>;

/// Weights where the tori fix a camera triple, and a line V/H.
struct FixedPoint {
    Residue weight{};           // by which the value of an integrand is multiplied
    std::array<Residue, 4> x{}; // of V
    Triple h{};                 // of the line bundles of the views
    std::array<Triple, 3> w{};  // of the bundles W that replace those of image vectors
    Triple image{};             // of the subbundles of W that an image of a point spans
    Triple isotropic{};         // of the locus where the camera has rank one, on an image line
    Triple null_y{};            // of null cameras, as in NullView; 0 for a regular one
    // For a null camera, what is not 0 of (delta : tau), or of the vector t if the camera has rank
    // two: 0 is delta, 1 and 2 are the coefficients of kappa kappa' and kappa'^2.
    std::array<std::size_t, 3> direction{};
    std::size_t translated = 0; // the view with the image of V/H
};

/// A view in which the quaternion is kappa w at a fixed point of A. The weights of kappa^2, kappa
/// kappa', kappa'^2 in W, less that of the second, are twice y, 0 and minus twice y.
struct NullView {
    std::size_t view = 0;
    Residue y{};
};

/// A fixed point of the space A of quaternions.
struct Quaternions {
    Residue factor{1};
    Residue z{}; // the roots of S are z and -z
    Triple h{};
    std::vector<Residue> tangents{};
    std::vector<NullView> nulls{};
};

inline Residue twice(Residue x) {
    return x + x;
}

inline Residue inverse(Residue x) {
    if (x == Residue{}) throw std::logic_error("the weights are not generic");
    return x.inverse();
}

/// Those where the view `regular` has an invertible quaternion. Each occurs twice, by the Weyl
/// group of SL_2: so the factor is 1/2.
inline void add_regular(std::vector<Quaternions>& all, const Triple& y, std::size_t regular) {
    for (unsigned signs = 0; signs < 16; ++signs) {
        const auto signed_by = [&](unsigned bit, Residue x) { return signs >> bit & 1 ? x : -x; };
        Quaternions at{Residue{2}.inverse(), signed_by(0, y[regular]), {}, {}, {}};
        Triple a{};
        for (unsigned k = 1; k <= 2; ++k) {
            const std::size_t view = (regular + k) % 3;
            const Residue null_y = signed_by(k, y[view]);
            a[view] = -(signed_by(3, k == 1 ? at.z : -at.z) + null_y);
            at.nulls.push_back({view, null_y});
        }
        for (std::size_t view = 0; view < 3; ++view) {
            at.h[view] = twice(a[view]);
            for (const Residue root : {at.z, -at.z})
                for (const Residue shift : {y[view], -y[view]}) {
                    const Residue weight = a[view] + root + shift;
                    // Scales and SL_2 are divided out.
                    if (weight == Residue{}) continue;
                    at.tangents.push_back(weight);
                }
        }
        for (const Residue root : {twice(at.z), -twice(at.z)}) {
            const auto found = std::find(at.tangents.begin(), at.tangents.end(), root);
            if (found == at.tangents.end()) throw std::logic_error("a root of SL_2 is missing");
            at.tangents.erase(found);
        }
        all.push_back(at);
    }
}

/// Those where no quaternion is invertible: SL_2 keeps three different kernels, so z = 0.
inline void add_null(std::vector<Quaternions>& all, const Triple& y) {
    for (unsigned signs = 0; signs < 8; ++signs) {
        Quaternions at;
        for (std::size_t view = 0; view < 3; ++view) {
            const Residue null_y = signs >> view & 1 ? y[view] : -y[view];
            at.h[view] = -twice(null_y);
            at.tangents.insert(at.tangents.end(), 2, at.h[view]);
            at.nulls.push_back({view, null_y});
        }
        all.push_back(at);
    }
}

/// A coordinate of W / H: of which view, and of kappa^2, kappa kappa' or kappa'^2.
struct Translation {
    std::size_t view = 0, power = 0;
    Residue weight{};
};

/// Three of them are the image of H: those of the regular view, or all kappa^2.
inline std::vector<Translation> translations(const Quaternions& at) {
    std::vector<Translation> result;
    for (const auto& [view, y] : at.nulls) {
        const Triple weights{at.h[view] + twice(y), at.h[view], at.h[view] - twice(y)};
        for (std::size_t power = at.nulls.size() == 3 ? 1 : 0; power < 3; ++power)
            result.push_back({view, power, weights[power]});
    }
    return result;
}

/// The fixed points of the blow-up over one of M, at the line `chosen` of W / H.
inline void add_points(std::vector<FixedPoint>& points, const Quaternions& at,
                       const Translation& chosen, const Triple& y) {
    FixedPoint start;
    start.x = {twice(at.z), {}, -twice(at.z), chosen.weight};
    start.h = start.image = at.h;
    for (std::size_t view = 0; view < 3; ++view)
        start.w[view] = {at.h[view] + twice(y[view]), at.h[view], at.h[view] - twice(y[view])};
    Residue normal{1};
    for (const Residue tangent : at.tangents)
        normal = normal * tangent;
    for (const auto& [view, null_y] : at.nulls)
        start.null_y[view] = null_y;
    start.direction[chosen.view] = chosen.power;
    start.translated = chosen.view;
    for (const Translation& other : translations(at))
        if (other.view != chosen.view || other.power != chosen.power)
            normal = normal * (other.weight - chosen.weight);
    start.weight = at.factor * inverse(normal);

    std::vector<FixedPoint> above{start};
    for (const auto& [view, null_y] : at.nulls) {
        if (chosen.view == view && chosen.power > 0) continue; // the camera has rank two
        const Triple rests{at.h[view] + twice(null_y), at.h[view], at.h[view] - twice(null_y)};
        const Triple normals{at.h[view], rests[1] - chosen.weight, rests[2] - chosen.weight};
        std::vector<FixedPoint> next;
        for (const FixedPoint& point : above)
            for (std::size_t i = 0; i < 3; ++i) {
                const Residue e = normals[i]; // of the exceptional divisor
                FixedPoint blown = point;
                for (std::size_t j = 0; j < 3; ++j)
                    if (j != i) blown.weight = blown.weight * normals[j] * inverse(normals[j] - e);
                blown.w[view] = {rests[0], rests[1] - e, rests[2] - e};
                blown.image[view] = at.h[view] - e;
                blown.isotropic[view] = e * (at.h[view] - rests[0]);
                blown.direction[view] = i;
                next.push_back(blown);
            }
        above = next;
    }
    points.insert(points.end(), above.begin(), above.end());
}

inline std::vector<FixedPoint> fixed_points(std::uint64_t seed = 5) {
    std::mt19937_64 random(seed);
    Triple y{};
    for (Residue& shift : y)
        shift = Residue::of(random());
    std::vector<Quaternions> quaternions;
    for (std::size_t regular = 0; regular < 3; ++regular)
        add_regular(quaternions, y, regular);
    add_null(quaternions, y);
    std::vector<FixedPoint> points;
    for (const Quaternions& at : quaternions)
        for (const Translation& chosen : translations(at))
            add_points(points, at, chosen, y);
    return points;
}

/// A point with pins, or a free line: bit v says whether view v sees it.
struct Feature {
    bool has_point = false;
    unsigned point = 0;            // which views see the point
    std::vector<unsigned> lines{}; // ... and each line through it, or the free line
};

inline bool sees(unsigned views, std::size_t view) {
    return (views >> view & 1) != 0;
}

/// The second Chern class of the condition that the point with this root is where the view sees it.
inline Residue seen_at(const FixedPoint& point, std::size_t view, Residue root) {
    const Triple& w = point.w[view];
    const Residue a = w[0] - root, b = w[1] - root, c = w[2] - root;
    const Residue r = point.image[view] - root;
    return a * b + a * c + b * c - (a + b + c) * r + r * r;
}

/// The class of a free line, where four different roots stand for those of V.
inline Residue class_of_line(const FixedPoint& point, unsigned views) {
    const auto& x = point.x;
    Residue sum;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            Residue above{1}, below{1};
            for (std::size_t view = 0; view < 3; ++view)
                if (sees(views, view))
                    above = above * (point.h[view] - x[i]) * (point.h[view] - x[j]);
            for (std::size_t l = 0; l < 4; ++l)
                if (l != i && l != j) below = below * (x[l] - x[i]) * (x[l] - x[j]);
            sum = sum + above * inverse(below);
        }
    for (const Residue locus : point.isotropic)
        sum = sum - locus;
    return sum;
}

/// What a line through the point with the j-th root adds.
inline Residue class_of_pin(const FixedPoint& at, const Feature& feature, unsigned views,
                            std::size_t j) {
    const auto& x = at.x;
    Residue sum;
    for (std::size_t l = 0; l < 4; ++l) {
        if (l == j) continue;
        Residue above{1}, below{1};
        for (std::size_t view = 0; view < 3; ++view) {
            if (!sees(views, view)) continue;
            above = above * (at.h[view] - x[l]);
            if (!sees(feature.point, view)) above = above * (at.h[view] - x[j]);
        }
        for (std::size_t k = 0; k < 4; ++k)
            if (k != j && k != l) below = below * (x[k] - x[l]);
        sum = sum + above * inverse(below);
    }
    return sum;
}

inline Residue class_of_point(const FixedPoint& at, const Feature& feature) {
    Residue sum;
    for (std::size_t j = 0; j < 4; ++j) {
        Residue above{1}, below{1};
        for (std::size_t view = 0; view < 3; ++view)
            if (sees(feature.point, view)) above = above * seen_at(at, view, at.x[j]);
        for (const unsigned views : feature.lines)
            above = above * class_of_pin(at, feature, views, j);
        for (std::size_t l = 0; l < 4; ++l)
            if (l != j) below = below * (at.x[l] - at.x[j]);
        sum = sum + above * inverse(below);
    }
    return sum;
}

/// The class of a feature, where the roots of V are different. If two views see a point and its
/// line, and the third view only the line, this may meet an isotropic point there.
inline Residue class_of(const FixedPoint& at, const Feature& feature) {
    if (!feature.has_point) return class_of_line(at, feature.lines[0]);
    Residue sum = class_of_point(at, feature);
    if (feature.lines != std::vector<unsigned>{0b111}) return sum;
    for (std::size_t view = 0; view < 3; ++view)
        if (feature.point == (0b111U ^ 1U << view))
            sum = sum - at.isotropic[view] * class_of_point(at, {true, feature.point, {}});
    return sum;
}

/// The class of a feature, a polynomial in the roots of V, also where some of these are the same:
/// from its values where they are moved apart.
inline Residue class_at(const FixedPoint& point, const Feature& feature) {
    constexpr std::uint64_t degree = 12; // more than that of any feature with seven pins
    constexpr std::array<std::uint64_t, 4> moves{1, 7919, 104729, 33};
    Residue value;
    for (std::uint64_t t = 1; t <= degree; ++t) {
        FixedPoint moved = point;
        for (std::size_t j = 0; j < 4; ++j)
            moved.x[j] = moved.x[j] + Residue{t * moves[j]};
        Residue factor{1}; // of Lagrange's formula, at 0
        for (std::uint64_t u = 1; u <= degree; ++u)
            if (u != t) factor = factor * Residue{u} * (Residue{u} - Residue{t}).inverse();
        value = value + class_of(moved, feature) * factor;
    }
    return value;
}

} // namespace proofs::blown_up
