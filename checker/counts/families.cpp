#include "checker/counts/families.h"

namespace checker {
/// Whether a property holds for each feature that occurs.
static bool all_features(const Signature& signature, const auto& property) {
    for (std::size_t i = 0; i < feature_count; ++i)
        if (signature[i] > 0 && !property(features[i])) return false;
    return true;
}

static unsigned pins_of_point(const Feature& feature) {
    return feature.free_line ? 0 : feature.pins;
}

static bool is_completely_visible(const Feature& feature) {
    if (!feature.free_line && feature.point != all_views) return false;
    for (unsigned i = 0; i < feature.pins; ++i)
        if (feature.pin[i] != all_views) return false;
    return true;
}

/// With respect to a view. Of a pin, the terminal feature has only what views see that do not see
/// its point: `Pa/P/a` becomes `P/P/a`.
static bool is_on_kileels_list(const Feature& feature, Views first) {
    if (feature.free_line) return true;                       // LLL
    if (feature.pins == 0) return feature.point == all_views; // PPP
    const bool two_views_see_pin = std::popcount(feature.pin[0]) == 2;
    const bool first_sees_point = (feature.point & first) != 0;
    return feature.pins == 1 && two_views_see_pin && first_sees_point; // PPL, PLP, PLL
}

/// If two views see a pin, the terminal feature drops it in the view that sees its point.
static bool leaves_dangling_pin(const Feature& feature) {
    return std::any_of(feature.pin.begin(), feature.pin.end(), [&](Views pin) {
        const bool seen_with_point = (pin & feature.point) != 0;
        return std::popcount(pin) == 2 && seen_with_point;
    });
}

/// Whether the relative pose of a pair of views fixes what they see of a feature.
static bool is_fixed_by(Views pair, const Feature& feature) {
    for (const Views pin : feature.pin)
        if (std::popcount(pin & pair) == 1) return false;
    const bool one_sees_point = std::popcount(feature.point & pair) == 1;
    return !one_sees_point || (feature.views & pair) == pair;
}

bool is_pl0p(const Signature& signature) {
    return all_features(signature, [](const Feature& f) { return pins_of_point(f) == 0; });
}

bool at_most_one_pin(const Signature& signature) {
    return all_features(signature, [](const Feature& f) { return pins_of_point(f) <= 1; });
}

bool completely_visible(const Signature& signature) {
    return all_features(signature, is_completely_visible);
}

std::string plmp_name(const Signature& signature) {
    unsigned points = 0, lines = 0, pins = 0, most_pins = 0;
    for (std::size_t i = 0; i < feature_count; ++i) {
        const unsigned count = signature[i];
        if (count == 0) continue;
        (features[i].free_line ? lines : points) += count;
        pins += count * pins_of_point(features[i]);
        most_pins = std::max(most_pins, pins_of_point(features[i]));
    }
    return std::to_string(points) + "0" + std::to_string(lines) + std::to_string(pins) + "_" +
           std::to_string(most_pins);
}

bool linear_in_trifocal_tensor(const Signature& signature) {
    for (const Views first : {0b001U, 0b010U, 0b100U}) {
        const auto listed = [&](const Feature& f) { return is_on_kileels_list(f, first); };
        if (all_features(signature, listed)) return true;
    }
    return false;
}

bool terminal_has_dangling_pins(const Signature& signature) {
    return !all_features(signature, [](const Feature& f) { return !leaves_dangling_pin(f); });
}

bool extends_five_points(const Signature& signature) {
    return std::any_of(view_pairs.begin(), view_pairs.end(),
                       [&](Views pair) { return shared_points(signature, pair) == 5; });
}

bool is_registration(const Signature& signature) {
    return std::any_of(view_pairs.begin(), view_pairs.end(), [&](Views pair) {
        const auto fixed = [&](const Feature& f) { return is_fixed_by(pair, f); };
        return shared_points(signature, pair) == 5 && all_features(signature, fixed);
    });
}
} // namespace checker
