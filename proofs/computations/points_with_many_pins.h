// Theorem K of proofs/points_with_many_pins.md: to which signatures it applies, and the class of a
// point with four or five pins on the blow-up of the space of calibrated cameras. By fixed points,
// modulo q = 2^61 - 1.
#pragma once

#include "proofs/computations/blown_up_cameras.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

namespace proofs::blown_up {

using Roots = std::vector<Residue>;

inline Residue product_of_differences(const Roots& roots, std::span<const std::size_t> without,
                                      Residue from) {
    Residue product{1};
    for (std::size_t i = 0; i < roots.size(); ++i)
        if (std::find(without.begin(), without.end(), i) == without.end())
            product = product * (roots[i] - from);
    return product;
}

constexpr std::uint64_t samples_of_roots = 16; // more than the degree of any class below

inline bool are_different(const Roots& roots) {
    for (const Residue root : roots)
        if (std::count(roots.begin(), roots.end(), root) > 1) return false;
    return true;
}

/// A symmetric polynomial of the roots that `value` computes where they are generic, also where
/// they are not: from its values where they are moved.
template <class Value>
Residue at_special_roots(const Roots& roots, bool generic, const Value& value) {
    constexpr std::array<std::uint64_t, 4> moves{1, 7919, 104729, 33};
    if (generic) return value(roots);
    static const Roots factors = lagrange_factors(samples_of_roots);
    Residue sum;
    for (std::uint64_t t = 1; t <= samples_of_roots; ++t) {
        Roots moved = roots;
        for (std::size_t i = 0; i < moved.size(); ++i)
            moved[i] = moved[i] + Residue{t * moves[i]};
        sum = sum + factors[t - 1] * value(moved);
    }
    return sum;
}

/// The integral of f(x, l) over all points X in lines of a bundle with these roots, where x and l
/// are the classes of X and of the line modulo X.
template <class F>
Residue integral_over_flags(const Roots& roots, const F& f) {
    return at_special_roots(roots, are_different(roots), [&](const Roots& r) {
        Residue sum;
        for (std::size_t i = 0; i < r.size(); ++i)
            for (std::size_t j = 0; j < r.size(); ++j) {
                if (i == j) continue;
                const std::array<std::size_t, 2> both{i, j};
                const Residue below = product_of_differences(r, std::span(both).first(1), r[i]) *
                                      product_of_differences(r, both, r[j]);
                sum = sum + f(r[i], r[j]) * inverse(below);
            }
        return sum;
    });
}

/// The integral of f(y) over all lines through the common kernel of two null views, which is a
/// trivial bundle: y is the class of the line modulo the kernel, and the roots are the other ones.
template <class F>
Residue integral_over_lines_through(const Roots& roots, const F& f) {
    Roots all = roots;
    all.push_back({}); // of the kernel
    return at_special_roots(roots, are_different(all), [&](const Roots& r) {
        Residue sum;
        for (std::size_t j = 0; j < r.size(); ++j)
            sum = sum + f(r[j]) * inverse(product_of_differences(r, std::array{j}, r[j]));
        return sum;
    });
}

inline Roots without(const Roots& roots, Residue root) {
    Roots rest = roots;
    const auto found = std::find(rest.begin(), rest.end(), root);
    if (found == rest.end()) throw std::logic_error("a root is missing");
    rest.erase(found);
    return rest;
}

/// The class of a point that all views see, with this many pins: the numbers of section 4 there at
/// one fixed point.
class StarClass {
public:
    StarClass(const Chart& chart, unsigned pins) : chart_(chart), at_(*chart.at), pins_(pins) {
        for (const Residue h : at_.h)
            sum_h_ = sum_h_ + h;
        for (const Residue x : at_.x)
            roots_.push_back(x);
        for (const Residue x : at_.x)
            c1_ = c1_ + x;
    }

    /// Without corrections: Lemma Z9.
    Residue uncorrected() const {
        checker::Feature star{.point = checker::all_views, .pins = pins_};
        std::fill_n(star.pin.begin(), pins_, checker::all_views);
        return class_of_visible_point(chart_, star);
    }

    Residue corrected() const {
        Residue sum = uncorrected();
        if (pins_ == 5) sum = sum + centres_on_a_line();
        for (std::size_t view = 0; view < 3; ++view)
            sum = sum - rank_one(view) - two_null(view);
        return sum;
    }

    /// Theta_u: camera u has rank one, and the line of the other two centres is in its kernel.
    Residue rank_one(std::size_t u) const {
        if (at_.isotropic[u] == Residue{}) return {};
        const std::size_t v = (u + 1) % 3, w = (u + 2) % 3;
        const Residue e = at_.h[u] - at_.image[u];
        const Roots kernel = without(roots_, square_of_kappa(u));
        const Residue all = integral_over_flags(kernel, [&](Residue x, Residue l) {
            return on_line(v, x, l) * on_line(w, x, l) * (rest_of_image(u) - x) *
                   of_rank_one(u, x, l);
        });
        return e * (all - isotropic_part(u, v, w, kernel) - isotropic_part(u, w, v, kernel));
    }

    /// Theta_uv: two cameras are null, and a line through their common kernel is seen as the point.
    Residue two_null(std::size_t third) const {
        if (chart_.both[third] == Residue{}) return {};
        return chart_.both[third] *
               integral_over_lines_through(without(roots_, {}), [&](Residue y) {
                   return lines_through_kernel(third, y) *
                          over_points_of_line(
                              y, [&](Residue x, Residue l) { return of_two_null(third, x, l); });
               });
    }

    /// Theta_0: the three centres are on a line.
    Residue centres_on_a_line() const {
        Residue sum = integral_over_flags(roots_, [&](Residue x, Residue l) {
            return on_line(0, x, l) * on_line(1, x, l) * on_line(2, x, l) * -x; // -x is 1 on lines
        });
        for (std::size_t third = 0; third < 3; ++third)
            if (chart_.both[third] != Residue{}) sum = sum - excess_of_two_null(third);
        return sum;
    }

private:
    Residue line_bundle_of_pins(Residue x) const { return sum_h_ - c1_ + x; }

    Residue seen(std::size_t view, Residue x) const { return value_at(point_seen(at_, view), x); }

    /// That the view sees the whole line as a given point.
    Residue on_line(std::size_t view, Residue x, Residue l) const {
        return seen(view, x) * seen(view, l);
    }

    /// Of image vectors modulo kappa squared and an image of a point, on E_u.
    Residue rest_of_image(std::size_t u) const { return at_.w[u][1] + at_.w[u][2] - at_.image[u]; }

    /// The class of kappa squared, a quotient of H.
    Residue square_of_kappa(std::size_t u) const {
        for (const Residue root : {at_.w[u][0], at_.w[u][2]})
            if (std::find(roots_.begin(), roots_.begin() + 3, root) != roots_.begin() + 3)
                return root;
        throw std::logic_error("the camera is not null");
    }

    /// The part of degree pins - 4 of (1 + L)^pins / c(N_u).
    Residue of_rank_one(std::size_t u, Residue x, Residue l) const {
        if (pins_ == 4) return Residue{1};
        const Residue e = at_.h[u] - at_.image[u];
        const Residue others = twice(sum_h_ - at_.h[u]) + square_of_kappa(u);
        return Residue{pins_} * line_bundle_of_pins(x) - (e + others - twice(l) - c1_ + x);
    }

    /// The part of degree pins - 3 of (1 + L)^pins / c(N_uv).
    Residue of_two_null(std::size_t third, Residue x, Residue l) const {
        const Residue a = chart_.both[third] + x - c1_; // V / H has the class c_1(V)
        const Residue b = square_of_kappa((third + 1) % 3) - l;
        const Residue c = square_of_kappa((third + 2) % 3) - l;
        const Residue n1 = a + b + c, n2 = a * b + a * c + b * c;
        const Residue k{pins_}, bundle = line_bundle_of_pins(x);
        if (pins_ == 4) return k * bundle - n1;
        const Residue pairs{pins_ * (pins_ - 1) / 2};
        return pairs * bundle * bundle - k * bundle * n1 + n1 * n1 - n2;
    }

    /// The integral over the points of a line through the kernel.
    template <class F>
    static Residue over_points_of_line(Residue y, const F& f) {
        return (f({}, y) - f(y, {})) * inverse(y);
    }

    /// That all views see such a line as a given point.
    Residue lines_through_kernel(std::size_t third, Residue y) const {
        return seen(0, y) * seen(1, y) * seen(2, y) * seen(third, {});
    }

    /// What the integral of rank_one has over two null views u, v.
    Residue isotropic_part(std::size_t u, std::size_t v, std::size_t w, const Roots& kernel) const {
        if (chart_.both[w] == Residue{}) return {};
        return chart_.both[w] * integral_over_lines_through(without(kernel, {}), [&](Residue y) {
                   const auto part = [&](Residue x, Residue l) { return of_rank_one(u, x, l); };
                   return seen(v, y) * on_line(w, {}, y) *
                          (part({}, y) + (rest_of_image(u) - c1_) * over_points_of_line(y, part));
               });
    }

    /// What the integral of centres_on_a_line has over two null views.
    Residue excess_of_two_null(std::size_t third) const {
        Residue rest = -chart_.both[third] - c1_;
        for (std::size_t view = 0; view < 3; ++view)
            if (view != third) rest = rest + at_.w[view][0] + rest_of_image(view);
        return chart_.both[third] *
               integral_over_lines_through(without(roots_, {}), [&](Residue y) {
                   return lines_through_kernel(third, y) * (rest + y);
               });
    }

    const Chart& chart_;
    const FixedPoint& at_;
    unsigned pins_ = 0;
    Residue sum_h_{}, c1_{};
    Roots roots_{};
};

/// The feature with four or five pins that the theorem speaks of.
inline bool is_star(const checker::Feature& feature) {
    return feature.pins == 4 || feature.pins == 5;
}

/// Whether the theorem's condition on what two views share holds.
inline bool views_share_few_points(const checker::Signature& signature) {
    for (std::size_t third = 0; third < 3; ++third) {
        const checker::Views pair = checker::all_views ^ 1U << third;
        std::size_t shared = 0, with_line = 0; // points other than the star
        for (std::size_t i = 0; i < checker::feature_count; ++i) {
            const checker::Feature& feature = checker::features[i];
            if ((feature.point & pair) != pair || is_star(feature)) continue;
            shared += signature[i];
            if (!sees(feature.point, third) && sees(feature.views, third))
                with_line += signature[i];
        }
        if (shared > 2 || (shared == 2 && with_line == 0)) return false;
    }
    return true;
}

/// Whether Theorem K speaks of a signature.
inline bool has_degree_with_many_pins(const checker::Signature& signature) {
    std::size_t stars = 0;
    for (std::size_t i = 0; i < checker::feature_count; ++i) {
        const checker::Feature& feature = checker::features[i];
        if (signature[i] == 0) continue;
        if (!is_star(feature) && feature.pins > 1) return false;
        if (is_star(feature)) stars += signature[i];
    }
    return stars == 1 && (most_pins(signature) == 4 || views_share_few_points(signature));
}

/// The class of a feature on the second blow-up, with the corrections of a point with four or five
/// pins.
inline Residue corrected_class_of(const Chart& chart, const checker::Feature& feature) {
    return is_star(feature) ? StarClass(chart, feature.pins).corrected() : class_of(chart, feature);
}

/// Integrals of products of a class of a point with four or five pins and classes of others.
inline Integrals integrals_with_stars(std::uint64_t seed = 5) {
    return Integrals(seed, charts_over, {corrected_class_of, 5});
}

} // namespace proofs::blown_up
