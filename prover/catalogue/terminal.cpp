#include "prover/catalogue/terminal.h"

#include <algorithm>

namespace plprove {

namespace {

using FeatureNames = std::array<std::string, feature_count>;

/// How many of the views that do not see the feature's point see one of its pins.
std::ptrdiff_t views_of_pins_only(const Feature& feature) {
    return std::ranges::count_if(
        feature.sights, [](const Sight& sight) { return !sight.point && sight.pins != 0; });
}

std::ptrdiff_t views_of_both(const Feature& feature) {
    return std::ranges::count_if(feature.sights,
                                 [](const Sight& sight) { return sight.point && sight.pins != 0; });
}

/// The sum of the features with these names; a name that occurs twice (a swap pair's) is counted in
/// one term.
std::string sum(const Signature& signature, const FeatureNames& names) {
    std::string text;
    for (std::size_t i = 0; i < feature_count;) {
        int count = signature[i];
        std::size_t next = i + 1;
        for (; next < feature_count && names[next] == names[i]; ++next)
            count += signature[next];
        if (count > 0) {
            if (!text.empty()) text += " + ";
            if (count > 1) text += std::to_string(count) + "*";
            text += names[i];
        }
        i = next;
    }
    return text;
}

template <class Form>
FeatureNames names_of(Form form) {
    FeatureNames names;
    std::ranges::transform(standard_features(), names.begin(),
                           [&](const Feature& feature) { return notation(form(feature)); });
    return names;
}

} // namespace

Feature terminal_form(const Feature& feature) {
    // A pin that two views see, one of them with the point, is fixed in space by them and tells
    // nothing about the cameras but that the other view's line meets the point: that is said by the
    // other view alone.
    Feature result = feature;
    if (!feature.has_point || views_of_both(feature) != 1 ||
        views_of_pins_only(feature) != feature.lines)
        return result;
    for (Sight& sight : result.sights)
        if (sight.point) sight.pins = 0;
    return result;
}

std::string terminal_notation(const Signature& signature) {
    static const FeatureNames names = names_of(terminal_form);
    return sum(signature, names);
}

std::string notation(const Signature& signature) {
    static const FeatureNames names = names_of([](const Feature& feature) { return feature; });
    return sum(signature, names);
}

} // namespace plprove
