#include "checker/problem.h"

#include <algorithm>
#include <functional>

namespace checker {

/// The feature of a notation of section 1.
static constexpr Feature observe(std::string_view notation) {
    Feature feature{.notation = notation};
    Views view = 1;
    for (const char symbol : notation) {
        if (symbol == '/') view <<= 1;
        if (symbol == '/' || symbol == '-') continue;
        feature.views |= view;
        const auto pin = static_cast<unsigned>(symbol - 'a');
        if (symbol != 'P') feature.pins = std::max(feature.pins, pin + 1);
        (symbol == 'P' ? feature.point : feature.pin[pin]) |= view;
        feature.equations += symbol != 'P' && (feature.point & view) ? 1 : 2;
    }
    return feature;
}

constexpr std::array<Feature, feature_count> features = [] {
    constexpr std::array<std::string_view, feature_count> notations{"Pabcdefg/Pabcdefg/Pabcdefg",
                                                                    "Pabcdef/Pabcdef/Pabcdef",
                                                                    "Pabcde/Pabcde/Pabcde",
                                                                    "Pabcd/Pabcd/Pabcd",
                                                                    "Pabc/Pabc/Pabc",
                                                                    "Pab/Pab/Pab",
                                                                    "Pa/Pa/Pa",
                                                                    "P/P/P",
                                                                    "a/Pa/Pa",
                                                                    "Pa/a/Pa",
                                                                    "Pa/Pa/a",
                                                                    "a/a/a",
                                                                    "a/P/Pa",
                                                                    "a/Pa/P",
                                                                    "P/a/Pa",
                                                                    "Pa/a/P",
                                                                    "P/Pa/a",
                                                                    "Pa/P/a",
                                                                    "-/P/P",
                                                                    "P/-/P",
                                                                    "P/P/-",
                                                                    "P/a/a",
                                                                    "a/P/a",
                                                                    "a/a/P",
                                                                    "Pab/b/a",
                                                                    "b/Pab/a",
                                                                    "b/a/Pab"};
    std::array<Feature, feature_count> all;
    std::transform(notations.begin(), notations.end(), all.begin(), observe);
    return all;
}();

/// The index of the feature that sees the same, up to the names of the pins. There must be one: in
/// the constant expressions below, to look beyond the list is a compile-time error.
static constexpr std::size_t index_of(Views point, const std::array<Views, 7>& pin) {
    for (std::size_t i = 0;; ++i)
        if (features[i].point == point &&
            std::is_permutation(pin.begin(), pin.end(), features[i].pin.begin()))
            return i;
}

constexpr std::array<Map, 6> relabelings = [] {
    std::array<Map, 6> maps{};
    std::array<unsigned, 3> to{0, 1, 2};
    for (Map& map : maps) {
        const auto rename = [&](Views v) {
            return (v & 1) << to[0] | (v >> 1 & 1) << to[1] | (v >> 2) << to[2];
        };
        for (std::size_t i = 0; i < feature_count; ++i) {
            std::array<Views, 7> pin{};
            std::transform(features[i].pin.begin(), features[i].pin.end(), pin.begin(), rename);
            map[index_of(rename(features[i].point), pin)] = i;
        }
        std::next_permutation(to.begin(), to.end());
    }
    return maps;
}();

/// Of a point with one pin that one view sees as a point only, one as a line only and one as both,
/// the first and the last view trade places. Other features stay what they are.
constexpr Map swaps = [] {
    Map map{};
    for (std::size_t i = 0; i < feature_count; ++i) {
        const Views point = features[i].point, line = features[i].pin[0];
        const bool swap =
            features[i].pins == 1 && (point & ~line) && (line & ~point) && (point & line);
        map[i] = swap ? index_of(point, {point ^ line}) : i;
    }
    return map;
}();

/// The largest signature of the label class, or of the swap&label class (then also the largest of
/// its label class): swaps commute with relabelings, and those towards the earlier feature enlarge.
static Signature largest(const Signature& signature, bool up_to_swaps) {
    Signature best{};
    for (const Map& map : relabelings) {
        Signature image{};
        for (std::size_t i = 0; i < feature_count; ++i)
            image[up_to_swaps ? std::min(i, swaps[i]) : i] += signature[map[i]];
        best = std::max(best, image);
    }
    return best;
}

/// Runs through the balanced signatures in decreasing lexicographic order. The entries before
/// `index` are chosen, and leave the weight `rest` to the others, which are zero so far.
static void enumerate(Signature& s, std::size_t index, unsigned rest, Classification& classes) {
    if (rest == 0) {
        ++classes.signatures;
        if (s == largest(s, false)) classes.representatives.push_back(s);
    } else if (index < feature_count) {
        const unsigned weight = features[index].weight();
        for (s[index] = rest / weight;; --s[index]) {
            enumerate(s, index + 1, rest - s[index] * weight, classes);
            if (s[index] == 0) break;
        }
    }
}

Classification classify() {
    Classification classes;
    Signature signature{};
    enumerate(signature, 0, camera_unknowns, classes);
    const auto& all = classes.representatives;
    for (const Signature& s : all) {
        const auto place =
            std::lower_bound(all.begin(), all.end(), largest(s, true), std::greater<>());
        classes.swap_class.push_back(static_cast<std::size_t>(place - all.begin()));
    }
    return classes;
}

std::string notation(const Signature& signature) {
    std::string text;
    for (std::size_t i = 0; i < feature_count; ++i) {
        if (signature[i] == 0) continue;
        if (!text.empty()) text += " + ";
        if (signature[i] > 1) text += std::to_string(signature[i]) + "*";
        text += features[i].notation;
    }
    return text;
}

unsigned shared_points(const Signature& signature, Views pair) {
    unsigned points = 0;
    for (std::size_t i = 0; i < feature_count; ++i)
        if ((features[i].point & pair) == pair) points += signature[i];
    return points;
}

Obstruction obstruction(const Signature& signature) {
    Obstruction found;
    for (std::size_t p = 0; p < view_pairs.size(); ++p)
        found.excess[p] = std::max(5U, shared_points(signature, view_pairs[p])) - 5;
    unsigned star = 0,
             lines = 0; // the star's pins: there are no two stars, as each weighs 6 or more
    Views seen = 0;     // the views that see anything of another feature
    for (std::size_t i = 0; i < feature_count; ++i) {
        if (signature[i] == 0) continue;
        if (features[i].pins >= 3) star = features[i].pins;
        if (features[i].pins < 3) seen |= features[i].views;
        if (features[i].point == 0) lines = signature[i];
    }
    found.star = star == 7 || (star == 6 && lines > 0) || (star >= 3 && seen != 0b111);
    return found;
}

} // namespace checker
