#include "checker/exactly/common_centres.h"

#include "checker/exactly/lines.h"

namespace checker::exactly {
/// Two views, without the third one.
static Views pair_without(std::size_t third) {
    return all_views ^ 1U << third;
}

Residue common_centre(const Chart& chart, std::size_t third) {
    return chart.at.x[3] - chart.both[third];
}

Polynomial point_seen(const FixedPoint& at, std::size_t view) {
    const auto& [a, b, c] = at.w[view];
    const Residue image = at.image[view], e1 = a + b + c, e2 = a * b + a * c + b * c;
    return {{e2 - e1 * image + image * image, image - e1, Residue{1}}};
}

Polynomial feature_seen(const FixedPoint& at, const Feature& feature, Views views) {
    Polynomial f{{Residue{1}}};
    for (std::size_t view = 0; view < 3; ++view)
        if (has_view(feature.point & views, view)) f = f * point_seen(at, view);
    for (std::size_t pin = 0; pin < feature.pins; ++pin)
        f = f * pin_seen(at, feature.pin[pin], feature.point);
    return f;
}

/// Whether it is `a/Pa/Pa`, and the view that sees the line only is the third one.
static bool sees_line_only(const Feature& feature, std::size_t third) {
    return feature.pins == 1 && feature.pin[0] == all_views && feature.point == pair_without(third);
}

/// What is left of the class where two null views see any point at their common kernel, a trivial
/// bundle.
static Residue class_of_point(const Chart& chart, const Feature& feature) {
    Residue sum = integral_over_points(feature_seen(chart.at, feature, all_views), chart.at.x);
    for (std::size_t third = 0; third < 3; ++third) {
        const Views pair = pair_without(third);
        if ((feature.point & pair) != pair) continue;
        sum = sum - chart.both[third] * value_at(feature_seen(chart.at, feature, 1U << third), {});
    }
    return sum;
}

Residue class_without_centres(const Chart& chart, const Feature& feature) {
    if (feature.free_line) return class_of_free_line(chart.at);
    Residue result = class_of_point(chart, feature);
    for (std::size_t third = 0; third < 3; ++third)
        if (sees_line_only(feature, third))
            result = result - chart.at.line_through_kappa(third) *
                                  class_of_point(chart, {.point = pair_without(third)});
    return result;
}

LinearClass class_of(const Chart& chart, const Feature& feature) {
    LinearClass result{class_without_centres(chart, feature)};
    if (feature.free_line) return result;
    for (std::size_t third = 0; third < 3; ++third) {
        const Views pair = pair_without(third);
        if ((feature.point & pair) != pair) continue;
        const Polynomial rest = feature_seen(chart.at, feature, 1U << third);
        result.common[third] = -value_at(rest, common_centre(chart, third));
        if (sees_line_only(feature, third)) // of the point, the class is -Gamma_uv there
            result.common[third] = result.common[third] + chart.at.line_through_kappa(third);
    }
    return result;
}

/// The power series in z of the product of 1 + root z, up to a degree.
static std::vector<Residue> total_class(const std::vector<Residue>& roots, std::size_t degree) {
    std::vector<Residue> c(degree + 1);
    c[0] = Residue{1};
    for (const Residue root : roots)
        for (std::size_t i = degree; i > 0; --i)
            c[i] = c[i] + root * c[i - 1];
    return c;
}

static void divide_by(std::vector<Residue>& c, const std::vector<Residue>& roots) {
    for (const Residue root : roots)
        for (std::size_t i = 1; i < c.size(); ++i)
            c[i] = c[i] - root * c[i - 1];
}

std::vector<Residue> powers_of_common_centres(const Chart& chart, std::size_t third,
                                              std::size_t most) {
    constexpr std::size_t codimension = 3;
    const Residue line = chart.at.x[3]; // V / H
    std::vector<Residue> above{-line}, below{chart.both[third] - line};
    for (std::size_t view = 0; view < 3; ++view)
        if (view != third)
            for (const Residue root : chart.at.w[view])
                above.push_back(root - line);
    for (std::size_t i = 0; i < 3; ++i) // V; its last root less `line` is 0
        below.push_back(chart.at.x[i] - line);
    std::vector<Residue> chern = total_class(above, most), segre = total_class(below, most);
    divide_by(chern, below);
    divide_by(segre, above);
    std::vector<Residue> powers(most + 1);
    powers[0] = Residue{1};
    for (std::size_t i = codimension; i <= most; ++i) {
        const Residue power = segre[i - codimension] * chern[codimension];
        powers[i] = i % 2 == 1 ? power : -power;
    }
    return powers;
}
} // namespace checker::exactly
