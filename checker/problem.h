// Problems (FORMAT.md, sections 1 and 4): the 27 features, signatures, their classes, obstructions.
// All follows from what each view sees of a feature: only the list of names is taken on trust.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <string>
#include <vector>

namespace checker {
inline constexpr std::size_t feature_count = 27, camera_unknowns = 11;

using Views = unsigned; // a set: 0b001 is view 1, 0b110 are the views 2 and 3
inline constexpr std::array<Views, 3> view_pairs{0b011, 0b101, 0b110};

/// A point with pins, or a free line, which is its one pin.
struct Feature {
    std::string_view notation{};
    bool free_line = false;
    Views point = 0, views = 0;       // those that see the point; that see anything
    std::array<Views, 26> pin{};      // those that see each pin
    unsigned pins = 0, equations = 0; // the latter: degrees of freedom in the images
    constexpr unsigned point_unknowns() const { return free_line ? 2 : 3; }
    constexpr unsigned unknowns() const { return point_unknowns() + 2 * pins; }
    constexpr unsigned weight() const { return equations - unknowns(); }
};

/// The feature of a notation, whose symbols are assumed to be those of section 1.
constexpr Feature observe(std::string_view notation) {
    Feature feature{.notation = notation};
    Views view = 1;
    bool point = false;
    for (const char symbol : notation) {
        const bool line = symbol >= 'a' && symbol <= 'z';
        if (symbol == '/') view <<= 1;
        if (symbol == '(') view = 0; // what no view sees follows
        if (symbol != 'P' && !line) continue;
        point |= symbol == 'P';
        feature.views |= view;
        const auto pin = static_cast<unsigned>(symbol - 'a');
        if (line) feature.pins = std::max(feature.pins, pin + 1);
        (line ? feature.pin[pin] : feature.point) |= view;
        if (view != 0) feature.equations += line && (feature.point & view) ? 1 : 2;
    }
    feature.free_line = !point && feature.pins == 1;
    return feature;
}

inline constexpr std::array<Feature, feature_count> features = [] {
    std::string_view names = "Pabcdefg/Pabcdefg/Pabcdefg Pabcdef/Pabcdef/Pabcdef "
                             "Pabcde/Pabcde/Pabcde Pabcd/Pabcd/Pabcd Pabc/Pabc/Pabc Pab/Pab/Pab "
                             "Pa/Pa/Pa P/P/P a/Pa/Pa Pa/a/Pa Pa/Pa/a a/a/a a/P/Pa a/Pa/P P/a/Pa "
                             "Pa/a/P P/Pa/a Pa/P/a -/P/P P/-/P P/P/- P/a/a a/P/a a/a/P Pab/b/a "
                             "b/Pab/a b/a/Pab ";
    std::array<Feature, feature_count> all;
    for (Feature& feature : all) {
        feature = observe(names.substr(0, names.find(' ')));
        names.remove_prefix(names.find(' ') + 1);
    }
    return all;
}();

/// The index of the feature that looks the same, up to names of pins; feature_count if none does.
constexpr std::size_t index_of(Views point, const std::array<Views, 26>& pin) {
    std::size_t i = 0;
    while (i < feature_count &&
           (features[i].point != point ||
            !std::is_permutation(pin.begin(), pin.end(), features[i].pin.begin())))
        ++i;
    return i;
}

using Map = std::array<std::size_t, feature_count>; // takes signatures s to t, t[i] = s[map[i]]

inline constexpr std::array<Map, 6> relabelings = [] {
    std::array<Map, 6> maps{};
    std::array<unsigned, 3> to{0, 1, 2};
    for (Map& map : maps) {
        const auto rename = [&](Views v) {
            return (v & 1) << to[0] | (v >> 1 & 1) << to[1] | (v >> 2) << to[2];
        };
        for (std::size_t i = 0; i < feature_count; ++i) {
            std::array<Views, 26> pin = features[i].pin;
            std::transform(pin.begin(), pin.end(), pin.begin(), rename);
            map[index_of(rename(features[i].point), pin)] = i;
        }
        std::next_permutation(to.begin(), to.end());
    }
    return maps;
}();

/// Of a point with one pin that one view sees as a point only, one as a line only and one as both,
/// the first and the last view trade places. Other features stay what they are.
inline constexpr Map swaps = [] {
    Map map{};
    for (std::size_t i = 0; i < feature_count; ++i) {
        const Views point = features[i].point, pin = features[i].pin[0];
        const bool swap = features[i].pins == 1 && point & ~pin && pin & ~point && point & pin;
        map[i] = swap ? index_of(point, {point ^ pin}) : i;
    }
    return map;
}();

using Signature = std::array<unsigned, feature_count>; // the multiplicity of each feature

/// The largest signature of the label class or of the swap&label class: swaps commute with
/// relabelings, and those towards the earlier feature of a pair make a signature larger.
inline Signature largest(const Signature& signature, bool up_to_swaps) {
    Signature best{};
    for (const Map& map : relabelings) {
        Signature image{};
        for (std::size_t i = 0; i < feature_count; ++i)
            image[up_to_swaps ? std::min(i, swaps[i]) : i] += signature[map[i]];
        best = std::max(best, image);
    }
    return best;
}

/// The balanced signatures, up to relabeling the views and up to swaps.
struct Classification {
    std::size_t signatures = 0;
    std::vector<Signature> representatives{}; // by class number, lexicographically decreasing
    std::vector<std::size_t> swap_class{};    // the first class of the same swap&label class
};

/// Runs through the balanced signatures in decreasing lexicographic order. The entries before
/// `index` are chosen, and leave the weight `rest` to the others, which are zero so far.
inline void enumerate(Signature& s, std::size_t index, unsigned rest, Classification& classes) {
    if (rest == 0) {
        ++classes.signatures;
        if (s == largest(s, false)) classes.representatives.push_back(s);
    } else if (index < feature_count) {
        const unsigned weight = features[index].weight();
        for (unsigned count = rest / weight + 1; count-- > 0;) {
            s[index] = count;
            enumerate(s, index + 1, rest - count * weight, classes);
        }
    }
}

/// The number of a balanced signature's label class, or of the first of its swap&label class.
inline std::size_t class_of(const Classification& classes, const Signature& s, bool up_to_swaps) {
    const auto& all = classes.representatives;
    const Signature first = largest(s, up_to_swaps);
    const auto place = std::lower_bound(all.begin(), all.end(), first, std::greater());
    return static_cast<std::size_t>(place - all.begin());
}

inline Classification classify() {
    Classification classes;
    Signature signature{};
    enumerate(signature, 0, camera_unknowns, classes);
    for (const Signature& s : classes.representatives)
        classes.swap_class.push_back(class_of(classes, s, true));
    return classes;
}

/// The signature in notation, as in `2*Pa/Pa/Pa + P/P/P`.
inline std::string notation(const Signature& signature) {
    std::string text;
    for (std::size_t i = 0; i < feature_count; ++i) {
        if (signature[i] == 0) continue;
        if (!text.empty()) text += " + ";
        if (signature[i] > 1) text += std::to_string(signature[i]) + "*";
        text += features[i].notation;
    }
    return text;
}

/// The number of points that both views of a pair see.
inline unsigned shared_points(const Signature& signature, Views pair) {
    unsigned points = 0;
    for (std::size_t i = 0; i < feature_count; ++i)
        if ((features[i].point & pair) == pair) points += signature[i];
    return points;
}

/// How many camera solutions a minimal problem has at most by Theorems U8, U11, U15 and U17 of
/// proofs/upper_bounds.md, on lines through a point and on two or three points; 0 if none says.
inline unsigned bound_by_theorem(const Signature& signature) {
    unsigned points = 0, pins = 0, most = 0; // that all views see; pins of these; of one of them
    unsigned lines = 0, free = 0;            // that all views see; free ones
    unsigned doubly = 0, whole = 0;          // points that two views see; a bound in U15
    bool pinned = false;                     // whether a doubly seen point has a pin
    Views views = 0; // of points that fewer see: the one that does alone, or alone does not
    for (std::size_t i = 0; i < feature_count; ++i) {
        const Feature& feature = features[i];
        const unsigned count = signature[i], seeing = unsigned(std::popcount(feature.point));
        if (count == 0) continue;
        for (const Views pin : feature.pin) lines += pin == 0b111 ? count : 0;
        free += feature.free_line ? count : 0;
        if (seeing == 3) points += count, pins += count * feature.pins;
        if (seeing == 3) most = std::max(most, feature.pins);
        if (seeing == 2) doubly += count, pinned |= feature.pins > 0;
        if (seeing == 1 || seeing == 2)
            views |= seeing == 1 ? feature.point : 0b111 - feature.point;
        if (feature.weight() == 2) whole = feature.free_line ? 216 : 272;
    }
    if (points == 3) { // and features of weight 2
        // By the number of doubly seen points, and whether `views` is one view (0: an extension).
        constexpr std::array<std::array<unsigned, 2>, 3> two{{{520, 448}, {368, 464}, {384, 0}}};
        if (pins == 2) return most == 2 ? 224 : 312;
        if (pins == 1) return doubly > 0 ? 304 : 376;
        return whole > 0 ? whole : two[doubly][std::popcount(views) == 1];
    }
    if (points == 2 && free == 2) return pins > 0 ? 264 : doubly > 0 ? 256 : 304;
    if (points == 2 && free == 1 && lines == 2 && pins == 0) return 240; // the other is a pin
    if (points == 0 || points - 1 + most < 5) return 0; // the lines to other points count
    if (points - 1 + most > 5) return 64;
    if (lines > most) return 240;                   // one of them is not through the point
    if (points == 2) return doubly > 0 ? 240 : 272; // a feature of weight 1 is left
    for (const Views pair : view_pairs)
        if ((pinned && doubly > 1) || shared_points(signature, pair) >= points + 2) return 272;
    return 0;
}

/// Why a problem is not minimal at any point (section 4).
struct Obstruction {
    std::array<unsigned, 3> excess{}; // of the pairs 12, 13, 23
    unsigned star = 0;                // S
    unsigned epipolar() const { return excess[0] + excess[1] + excess[2]; } // E
    unsigned deficiency() const { return std::max(epipolar(), star); }
    bool minimal() const { return deficiency() == 0; }
};

/// The obstruction of a balanced signature.
inline Obstruction obstruction(const Signature& signature) {
    Obstruction found;
    for (std::size_t p = 0; p < view_pairs.size(); ++p)
        found.excess[p] = std::max(5U, shared_points(signature, view_pairs[p])) - 5;
    unsigned star = 0, lines = 0; // the star's pins: two stars weigh too much to be balanced
    Views seen = 0;               // the views that see anything of another feature
    for (std::size_t i = 0; i < feature_count; ++i) {
        if (signature[i] == 0) continue;
        if (features[i].pins >= 3) star = features[i].pins;
        if (features[i].pins < 3) seen |= features[i].views;
        if (features[i].free_line) lines = signature[i];
    }
    found.star = star == 7 || (star == 6 && lines > 0) || (star >= 3 && seen != 0b111);
    return found;
}
} // namespace checker
