// Theorem Z of proofs/blown_up_cameras.md: to which signatures it applies, and their degrees, which
// are integrals over a blow-up of the space M of calibrated cameras. By fixed points, modulo
// q = 2^61 - 1.
#pragma once

#include "checker/minimal/obstruction.h"
#include "checker/problem/classes.h"
#include "proofs/computations/blown_up_moduli.h"
#include "proofs/computations/incident_lines.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace proofs::blown_up {

/// A polynomial in one variable, by its coefficients.
using Polynomial = std::vector<Residue>;

inline Polynomial operator*(const Polynomial& f, const Polynomial& g) {
    Polynomial product(f.size() + g.size() - 1);
    for (std::size_t i = 0; i < f.size(); ++i)
        for (std::size_t j = 0; j < g.size(); ++j)
            product[i + j] = product[i + j] + f[i] * g[j];
    return product;
}

inline Residue value_at(const Polynomial& f, Residue x) {
    Residue value;
    for (std::size_t i = f.size(); i-- > 0;)
        value = value * x + f[i];
    return value;
}

/// The integral over P(V) of a polynomial in the class of the tautological line: minus the divided
/// difference at the four roots, which may be the same.
inline Residue integral_over_points(const Polynomial& f, const std::array<Residue, 4>& roots) {
    Residue sum;
    if (f.size() < roots.size()) return sum;
    Polynomial complete(f.size() - 3); // the complete symmetric polynomials of the roots
    complete[0] = Residue{1};
    for (const Residue root : roots)
        for (std::size_t i = 1; i < complete.size(); ++i)
            complete[i] = complete[i] + root * complete[i - 1];
    for (std::size_t i = 0; i < complete.size(); ++i)
        sum = sum - f[i + 3] * complete[i];
    return sum;
}

/// A fixed point of the second blow-up: one of the first, the classes of the divisors of null
/// cameras, and of those over two null views, ordered by the view that they lack. Values there
/// count `factor` times.
struct Chart {
    const FixedPoint* at = nullptr;
    Triple null{};
    Residue factor{1};
    Triple both{};
    // Only on the third blow-up (common_centres.h), in the same order: the divisors over a common
    // centre of two views, and the class of this centre.
    Triple same_centre{};
    Triple centre{};
};

/// The fixed points over one of the first blow-up, if null[v] is the class of the divisor of null
/// cameras v there. They must not be the same, unless they are 0.
inline std::vector<Chart> toric_charts(const FixedPoint& at, const Triple& null) {
    std::vector<std::size_t> views;
    for (std::size_t view = 0; view < 3; ++view)
        if (null[view] != Residue{}) views.push_back(view);
    if (views.size() < 2) return {{&at, null}};
    std::vector<Chart> charts;
    do {
        Chart chart{&at, null};
        // The blow-up has the weights d_i, d_j - d_i, d_k - d_j there, in the order i, j, k.
        for (std::size_t i = 0; i + 1 < views.size(); ++i) {
            const Residue d = null[views[i]], next = null[views[i + 1]];
            chart.factor = chart.factor * next * inverse(next - d);
            for (std::size_t j = i + 1; j < views.size(); ++j)
                chart.both[3 - views[i] - views[j]] = d;
        }
        charts.push_back(chart);
    } while (std::next_permutation(views.begin(), views.end()));
    return charts;
}

/// The factors of Lagrange's formula for the value at 0, from those at 1, 2, ..., `samples`.
inline std::vector<Residue> lagrange_factors(std::uint64_t samples) {
    std::vector<Residue> factors;
    for (std::uint64_t t = 1; t <= samples; ++t) {
        Residue factor{1};
        for (std::uint64_t u = 1; u <= samples; ++u)
            if (u != t) factor = factor * Residue{u} * (Residue{u} - Residue{t}).inverse();
        factors.push_back(factor);
    }
    return factors;
}

/// The same for all classes: integrals over the fibres are polynomials in the three classes, of
/// degree at most 11. Where two are the same, the value is interpolated from others.
inline std::vector<Chart> charts_over(const FixedPoint& at) {
    const Triple& null = at.image;
    bool generic = true;
    for (std::size_t view = 0; view < 3; ++view)
        generic = generic && (null[view] == Residue{} || null[view] != null[(view + 1) % 3]);
    if (generic) return toric_charts(at, null);
    constexpr std::uint64_t samples = checker::camera_unknowns + 1;
    static const std::vector<Residue> factors = lagrange_factors(samples);
    constexpr std::array<std::uint64_t, 3> moves{1, 7919, 104729};
    std::vector<Chart> charts;
    for (std::uint64_t t = 1; t <= samples; ++t) {
        Triple moved = null;
        for (std::size_t view = 0; view < 3; ++view)
            if (null[view] != Residue{}) moved[view] = null[view] + Residue{t * moves[view]};
        for (Chart chart : toric_charts(at, moved)) {
            chart.factor = chart.factor * factors[t - 1];
            charts.push_back(chart);
        }
    }
    return charts;
}

/// The class of the condition that the point is where the view sees it.
inline Polynomial point_seen(const FixedPoint& at, std::size_t view) {
    const auto& [a, b, c] = at.w[view];
    const Residue image = at.image[view], e1 = a + b + c, e2 = a * b + a * c + b * c;
    return {e2 - e1 * image + image * image, image - e1, Residue{1}};
}

/// The class of the condition that a line through the point is where these views see it, of which
/// those in `point` see the point, too.
inline Polynomial line_seen(const FixedPoint& at, checker::Views views, checker::Views point) {
    Polynomial f{Residue{1}};
    for (std::size_t view = 0; view < 3; ++view)
        if (sees(views & ~point, view)) f = f * Polynomial{at.h[view], -Residue{1}};
    if (views != checker::all_views) return f;
    Residue rest;
    for (std::size_t view = 0; view < 3; ++view)
        rest = rest + at.h[view];
    for (const Residue root : at.x)
        rest = rest - root;
    return f * Polynomial{rest, Residue{1}};
}

/// Those of all that the views in `views` see of a feature with a point.
inline Polynomial feature_seen(const FixedPoint& at, const checker::Feature& feature,
                               checker::Views views) {
    Polynomial f{Residue{1}};
    for (std::size_t view = 0; view < 3; ++view)
        if (sees(feature.point & views, view)) f = f * point_seen(at, view);
    for (std::size_t pin = 0; pin < feature.pins; ++pin)
        f = f * line_seen(at, feature.pin[pin], feature.point);
    return f;
}

/// What is left of the class where two null views see any point at their common kernel, and where
/// two views see any point at their common centre.
inline Residue class_of_visible_point(const Chart& chart, const checker::Feature& feature) {
    const FixedPoint& at = *chart.at;
    Residue sum = integral_over_points(feature_seen(at, feature, checker::all_views), at.x);
    for (std::size_t view = 0; view < 3; ++view) {
        const checker::Views pair = checker::all_views ^ 1U << view;
        if ((feature.point & pair) != pair) continue;
        const Polynomial rest = feature_seen(at, feature, 1U << view);
        // The kernel is a trivial bundle.
        sum = sum - chart.both[view] * value_at(rest, {});
        sum = sum - chart.same_centre[view] * value_at(rest, chart.centre[view]);
    }
    return sum;
}

/// The class of a free line that all views see.
inline Residue class_of_free_line(const FixedPoint& at) {
    Residue result = class_of_incident_line(at.x, at.h);
    for (const Residue locus : at.isotropic)
        result = result - locus;
    return result;
}

/// The class of a feature (Lemma Z9 of proofs/blown_up_classes.md).
inline Residue class_of(const Chart& chart, const checker::Feature& feature) {
    if (feature.free_line) return class_of_free_line(*chart.at);
    Residue result = class_of_visible_point(chart, feature);
    const bool all_see_a_pin = feature.pins == 1 && feature.pin[0] == checker::all_views;
    for (std::size_t view = 0; view < 3; ++view) {
        const checker::Views pair = checker::all_views ^ 1U << view;
        if (!all_see_a_pin || feature.point != pair) continue;
        const checker::Feature point{.point = pair};
        const Residue of_point = class_of_visible_point(chart, point);
        result = result - chart.at->isotropic[view] * of_point;
    }
    return result;
}

/// How many conditions data of a feature put on the image of a common centre of two cameras, and on
/// their relative rotation: a way of Lemma Z8.
struct Way {
    unsigned on_image = 0, on_rotation = 0;
};

/// All ways of a feature, where the other two views than the third one have the same centre.
inline std::vector<Way> ways(const checker::Feature& feature, std::size_t third) {
    const checker::Views pair = checker::all_views ^ 1U << third, pin = feature.pin[0];
    if (feature.free_line) return {{1, 0}, {0, 2}};
    if ((feature.point & pair) == pair) {
        if (sees(feature.point, third)) return {{2, 0}};
        return sees(feature.views, third) ? std::vector<Way>{{1, 0}} : std::vector<Way>{{0, 0}};
    }
    const bool third_sees_point = sees(feature.point, third);
    const bool another_sees_point = (feature.point & pair) != 0;
    if (!third_sees_point) return {{1, 0}, {0, 1}};
    if (!another_sees_point || feature.pins == 0) return {{0, 0}};
    if (pin == checker::all_views) return {{2, 0}, {1, 1}, {0, 2}};
    return {{2, 0}, {0, 1}};
}

/// Whether some choice of ways puts at most two conditions on the image and three on the rotation.
inline bool may_have_common_centre(const checker::Signature& signature, std::size_t third) {
    using Conditions = std::array<std::array<bool, 4>, 3>;
    Conditions possible{};
    possible[0][0] = true;
    for (std::size_t i = 0; i < checker::feature_count; ++i) {
        for (unsigned n = 0; n < signature[i]; ++n) {
            Conditions next{};
            for (const auto& [on_image, on_rotation] : ways(checker::features[i], third))
                for (std::size_t image = on_image; image <= 2; ++image)
                    for (std::size_t rotation = on_rotation; rotation <= 3; ++rotation)
                        next[image][rotation] = next[image][rotation] ||
                                                possible[image - on_image][rotation - on_rotation];
            possible = next;
        }
    }
    return possible != Conditions{};
}

/// How many points this view and another one see.
inline unsigned points_shared_by(const checker::Signature& signature, std::size_t view) {
    unsigned count = 0;
    for (std::size_t i = 0; i < checker::feature_count; ++i)
        if (sees(checker::features[i].point, view) && std::popcount(checker::features[i].point) > 1)
            count += signature[i];
    return count;
}

/// The largest number of pins of a point.
inline unsigned most_pins(const checker::Signature& signature) {
    unsigned most = 0;
    for (std::size_t i = 0; i < checker::feature_count; ++i)
        if (signature[i] > 0) most = std::max(most, checker::features[i].pins);
    return most;
}

/// Whether Theorem Z speaks of a signature.
inline bool has_degree_by_blow_up(const checker::Signature& signature) {
    const unsigned pins = most_pins(signature);
    if (pins > 3) return false;
    for (std::size_t view = 0; view < 3; ++view) {
        if (points_shared_by(signature, view) > (pins == 3 ? 4 : 5)) return false;
        const unsigned shared = checker::shared_points(signature, checker::all_views ^ 1U << view);
        if (shared > 3) return false;
        if (shared == 3 && may_have_common_centre(signature, view)) return false;
    }
    return true;
}

/// The integer of least absolute value with this residue.
inline std::int64_t signed_value(Residue residue) {
    const auto value = static_cast<std::int64_t>(residue.value);
    const auto q = static_cast<std::int64_t>(checker::modulus);
    return value > q / 2 ? value - q : value;
}

/// The classes of features at a chart, and how many pins a point may have for them.
struct FeatureClasses {
    Residue (*of)(const Chart&, const checker::Feature&) = class_of;
    unsigned pins = 3;
};

/// Integrals of products of classes of features.
class Integrals {
public:
    /// For a signature without features like `Pab/b/a`: of its constraint class.
    std::int64_t of(const checker::Signature& signature) const {
        std::vector<std::size_t> factors;
        for (std::size_t i = 0; i < checker::feature_count; ++i)
            factors.insert(factors.end(), signature[i], i);
        Residue sum;
        for (const auto& [factor, values] : charts_) {
            Residue product = factor;
            for (const std::size_t i : factors)
                product = product * values[i];
            sum = sum + product;
        }
        return signed_value(sum);
    }

    using ChartsOver = std::vector<Chart> (*)(const FixedPoint&);

    /// The charts are those of the second blow-up, or of the third.
    explicit Integrals(std::uint64_t seed = 5, ChartsOver charts = charts_over,
                       FeatureClasses classes = {}) {
        for (const FixedPoint& at : fixed_points(seed)) {
            for (const Chart& chart : charts(at)) {
                Values values{chart.factor * at.weight, {}};
                for (std::size_t i = 0; i < checker::feature_count; ++i)
                    if (checker::features[i].pins <= classes.pins)
                        values.features[i] = classes.of(chart, checker::features[i]);
                charts_.push_back(values);
            }
        }
    }

private:
    struct Values {
        Residue factor{};
        std::array<Residue, checker::feature_count> features{};
    };
    std::vector<Values> charts_{};
};

} // namespace proofs::blown_up
