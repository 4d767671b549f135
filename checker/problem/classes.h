// Signatures, and their classes up to relabeling the views, swaps and exchanges (FORMAT.md,
// sections 1 and 9).
#pragma once

#include "checker/problem/features.h"

#include <functional>
#include <string>
#include <vector>

namespace checker {
/// The multiplicity of each feature.
using Signature = std::array<unsigned, feature_count>;

/// Takes a signature s to t with t[i] = s[map[i]].
using FeatureMap = std::array<std::size_t, feature_count>;

/// The permutation of features by a permutation of the views: view v becomes to[v].
constexpr FeatureMap relabeling(const std::array<unsigned, 3>& to) {
    const auto relabeled = [&](Views views) {
        Views result = 0;
        for (std::size_t v = 0; v < 3; ++v)
            if (has_view(views, v)) result |= 1U << to[v];
        return result;
    };
    FeatureMap map{};
    for (std::size_t i = 0; i < feature_count; ++i) {
        Feature image = features[i];
        image.point = relabeled(image.point);
        for (std::size_t pin = 0; pin < image.pins; ++pin)
            image.pin[pin] = relabeled(image.pin[pin]);
        map[index_of(image)] = i;
    }
    return map;
}

inline constexpr std::array<FeatureMap, 6> relabelings{
    relabeling({0, 1, 2}), relabeling({0, 2, 1}), relabeling({1, 0, 2}),
    relabeling({1, 2, 0}), relabeling({2, 0, 1}), relabeling({2, 1, 0})};

/// The swap: of a point with one pin that one view sees as a point only, one as a line only and one
/// as both, the first and the last view trade places. Takes a feature to the earlier of the pair,
/// other features to themselves.
inline constexpr FeatureMap earlier_of_swap = [] {
    FeatureMap map{};
    for (std::size_t i = 0; i < feature_count; ++i) {
        const Views point = features[i].point;
        const Views pin = features[i].pin[0];
        const Views point_only = point & ~pin, line_only = pin & ~point, both = point & pin;
        const bool has_swap = features[i].pins == 1 && point_only && line_only && both;
        map[i] = i;
        if (!has_swap) continue;
        Feature other = features[i];
        other.pin[0] = line_only | point_only;
        map[i] = std::min(i, index_of(other));
    }
    return map;
}();

/// The largest of the relabeled signatures, in which `merge` takes features to others.
constexpr Signature largest_image(const Signature& signature, const FeatureMap& merge) {
    Signature largest{};
    for (const FeatureMap& map : relabelings) {
        Signature image{};
        for (std::size_t i = 0; i < feature_count; ++i)
            image[merge[i]] += signature[map[i]];
        largest = std::max(largest, image);
    }
    return largest;
}

/// The largest signature of the label class.
constexpr Signature largest_relabeled(const Signature& signature) {
    return largest_image(signature, relabelings[0]);
}

/// Whether it is the largest of its label class: `signature == largest_relabeled(signature)`, but
/// most comparisons are decided after a few features.
constexpr bool represents_label_class(const Signature& signature) {
    for (const FeatureMap& map : relabelings) {
        std::size_t i = 0;
        while (i < feature_count && signature[map[i]] == signature[i])
            ++i;
        if (i < feature_count && signature[map[i]] > signature[i]) return false;
    }
    return true;
}

/// The largest signature of the swap&label class: swaps commute with relabelings, and those towards
/// the earlier feature of a pair make a signature larger.
constexpr Signature largest_swapped(const Signature& signature) {
    return largest_image(signature, earlier_of_swap);
}

/// The balanced signatures, up to relabeling the views and up to swaps.
struct Classification {
    std::size_t signatures = 0;               // balanced ones
    std::vector<Signature> representatives{}; // by class number, lexicographically decreasing
    std::vector<std::size_t> swap_class{};    // the first class of the same swap&label class

    /// Whether the class stands for its swap&label class.
    bool represents_swap_class(std::size_t number) const { return swap_class[number] == number; }
};

/// The number of the class with this representative, which is one.
inline std::size_t number_of(const Classification& classes, const Signature& representative) {
    const auto& all = classes.representatives;
    const auto place = std::lower_bound(all.begin(), all.end(), representative, std::greater());
    return static_cast<std::size_t>(place - all.begin());
}

/// Runs through the balanced signatures in decreasing lexicographic order. The entries before
/// `index` are chosen, and leave the weight `rest` to the others, which are zero so far.
inline void enumerate(Signature& signature, std::size_t index, unsigned rest,
                      Classification& classes) {
    if (rest == 0) {
        ++classes.signatures;
        if (represents_label_class(signature)) classes.representatives.push_back(signature);
        return;
    }
    if (index == feature_count) return;
    const unsigned weight = features[index].weight();
    for (unsigned count = rest / weight + 1; count-- > 0;) {
        signature[index] = count;
        enumerate(signature, index + 1, rest - count * weight, classes);
    }
}

inline Classification classify() {
    Classification classes;
    Signature signature{};
    enumerate(signature, 0, camera_unknowns, classes);
    for (const Signature& representative : classes.representatives)
        classes.swap_class.push_back(number_of(classes, largest_swapped(representative)));
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
} // namespace checker
