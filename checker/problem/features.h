// The 27 local features (FORMAT.md, section 1). What each view sees of a feature says everything
// about it; only the list of names is taken on trust.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <string_view>

namespace checker {
inline constexpr std::size_t feature_count = 27;
inline constexpr std::size_t camera_unknowns = 11;

/// A set of views: 0b001 is view 1, 0b110 are the views 2 and 3.
using Views = unsigned;
inline constexpr Views all_views = 0b111;
inline constexpr std::array<Views, 3> view_pairs{0b011, 0b101, 0b110};

/// Whether the set has this view: 0, 1 or 2.
constexpr bool has_view(Views views, std::size_t view) {
    return (views >> view & 1) != 0;
}

/// For each pin of a point, the views that see it.
using Pins = std::array<Views, 26>;

/// A point with pins, or a free line, which is its one pin.
struct Feature {
    std::string_view notation{};
    bool free_line = false;
    Views point = 0; // that see the point
    Views views = 0; // that see anything of the feature
    Pins pin{};
    unsigned pins = 0;
    unsigned equations = 0; // degrees of freedom in the images

    constexpr unsigned point_unknowns() const { return free_line ? 2 : 3; }
    constexpr unsigned unknowns() const { return point_unknowns() + 2 * pins; }
    constexpr unsigned weight() const { return equations - unknowns(); }
};

/// The feature of a notation, whose symbols are assumed to be those of section 1.
constexpr Feature observe(std::string_view notation) {
    Feature feature{.notation = notation};
    Views view = 0b001;
    bool has_point = false;
    for (const char symbol : notation) {
        if (symbol == '/') view <<= 1;
        if (symbol == '(') view = 0; // what no view sees follows
        if (symbol == 'P') {
            has_point = true;
            feature.point |= view;
            if (view != 0) feature.equations += 2;
        } else if (symbol >= 'a' && symbol <= 'z') {
            const auto pin = static_cast<unsigned>(symbol - 'a');
            const bool through_seen_point = (feature.point & view) != 0;
            feature.pins = std::max(feature.pins, pin + 1);
            feature.pin[pin] |= view;
            if (view != 0) feature.equations += through_seen_point ? 1 : 2;
        } else {
            continue;
        }
        feature.views |= view;
    }
    feature.free_line = !has_point && feature.pins == 1;
    return feature;
}

inline constexpr std::array<Feature, feature_count> features = [] {
    std::string_view names = // in the authors' order
        "Pabcdefg/Pabcdefg/Pabcdefg Pabcdef/Pabcdef/Pabcdef Pabcde/Pabcde/Pabcde "
        "Pabcd/Pabcd/Pabcd Pabc/Pabc/Pabc "
        "Pab/Pab/Pab Pa/Pa/Pa P/P/P a/Pa/Pa Pa/a/Pa "
        "Pa/Pa/a a/a/a a/P/Pa a/Pa/P P/a/Pa "
        "Pa/a/P P/Pa/a Pa/P/a -/P/P P/-/P "
        "P/P/- P/a/a a/P/a a/a/P Pab/b/a "
        "b/Pab/a b/a/Pab ";
    std::array<Feature, feature_count> all;
    for (Feature& feature : all) {
        const std::size_t end = names.find(' ');
        feature = observe(names.substr(0, end));
        names.remove_prefix(end + 1);
    }
    return all;
}();

/// The index of the feature that looks the same, up to the names of pins; feature_count if none
/// does.
constexpr std::size_t index_of(Views point, const Pins& pin) {
    std::size_t i = 0;
    for (; i < feature_count; ++i) {
        const Feature& feature = features[i];
        const bool same_pins = std::is_permutation(pin.begin(), pin.end(), feature.pin.begin());
        if (feature.point == point && same_pins) break;
    }
    return i;
}

/// The index of the feature that the table calls so; feature_count if none.
constexpr std::size_t index_of(std::string_view notation) {
    std::size_t i = 0;
    while (i < feature_count && features[i].notation != notation)
        ++i;
    return i;
}
} // namespace checker
