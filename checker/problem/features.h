// Local features, and the table of the 27 (FORMAT.md, section 1). What each view sees of a feature
// says everything about it; only the list of names is taken on trust.
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

/// Whether the set has this view. Views are numbered from 0.
constexpr bool has_view(Views views, std::size_t view) {
    return (views >> view & 1) != 0;
}

/// A letter of a notation names a line: `a` to `z`, and `A` to `Z` without `P`, which is a point.
inline constexpr std::size_t most_letters = 51;

constexpr bool is_capital(char c) {
    return c >= 'A' && c <= 'Z' && c != 'P';
}

constexpr bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || is_capital(c);
}

/// For each pin of a point, the views that see it.
using Pins = std::array<Views, most_letters>;

/// A point with pins, the lines through it; or a free line, which is its one pin.
struct Feature {
    std::string_view notation{};
    bool free_line = false;
    Views point = 0; // that see the point
    Views views = 0; // that see anything of the feature
    Pins pin{};
    std::array<char, most_letters> letter{}; // of each pin, ascending: capital letters first
    unsigned pins = 0;
    unsigned equations = 0; // degrees of freedom in the images

    constexpr unsigned point_unknowns() const { return free_line ? 2 : 3; }
    constexpr unsigned unknowns() const { return point_unknowns() + 2 * pins; }
    constexpr unsigned weight() const { return equations - unknowns(); }
};

/// The feature of a notation that is spelled as sections 1 and 13 say; of another text, some
/// feature that is spelled otherwise.
constexpr Feature observe(std::string_view notation) {
    Feature feature{.notation = notation};
    for (char c = 'A'; c <= 'z'; ++c)
        if (is_letter(c) && notation.find(c) != notation.npos) feature.letter[feature.pins++] = c;
    Views view = 0b001;
    bool has_point = feature.pins > 1;
    for (const char symbol : notation) {
        if (symbol == '/') view <<= 1;
        if (symbol == '(') view = 0; // what no view sees follows
        if (symbol == 'P') {
            has_point = true;
            feature.point |= view;
            if (view != 0) feature.equations += 2;
        } else if (is_letter(symbol)) {
            std::size_t pin = 0;
            while (feature.letter[pin] != symbol)
                ++pin;
            const bool through_seen_point = (feature.point & view) != 0;
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

/// Whether two features look the same, up to the names and the order of their pins.
constexpr bool look_alike(const Feature& a, const Feature& b) {
    return a.free_line == b.free_line && a.point == b.point && a.pins == b.pins &&
           std::is_permutation(a.pin.begin(), a.pin.begin() + a.pins, b.pin.begin());
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

/// The index of the feature that looks like this one; feature_count if none does.
constexpr std::size_t index_of(const Feature& feature) {
    std::size_t i = 0;
    while (i < feature_count && !look_alike(features[i], feature))
        ++i;
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
