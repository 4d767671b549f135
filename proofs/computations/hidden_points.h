// Upper bounds on degrees where view 1 does not see one to three points (Theorem S of
// proofs/relations.md, section 10), and problems of the same degree (Theorem X, section 11).
#pragma once

#include "checker/minimal/obstruction.h"
#include "proofs/computations/feature_classes.h"

#include <algorithm>
#include <set>

namespace proofs {

/// The features with a point that view 1 does not see, of weight 1: how many there are of each.
struct HiddenPoints {
    unsigned t_2 = 0; // a/P/a
    unsigned t_3 = 0; // a/a/P
    unsigned e_1 = 0; // -/P/P

    unsigned number() const { return t_2 + t_3 + e_1; }
};

inline HiddenPoints hidden_points(const checker::Signature& signature) {
    const auto count = [&](std::string_view notation) {
        return signature[checker::index_of(notation)];
    };
    return {count("a/P/a"), count("a/a/P"), count("-/P/P")};
}

/// The product of their classes: T + N_2, T + N_3 and T + N_2 + N_3 - e, where N_v = 2 h_v - y_v.
inline Cycle cycle_of(const HiddenPoints& hidden) {
    const Cycle visible = FeatureClasses{}.T;
    const Cycle with_2 = visible + 2 * class_of(h2) - class_of(y2);
    const Cycle with_3 = visible + 2 * class_of(h3) - class_of(y3);
    const Cycle with_both = with_2 + with_3 - visible - class_of(e);
    return power(with_2, hidden.t_2) * power(with_3, hidden.t_3) * power(with_both, hidden.e_1);
}

/// Whether a feature of feature_lists() has a line or a pin that all views see.
inline bool is_in_last_four_rows(std::string_view feature) {
    return feature == "a/a/a" || feature.starts_with("Pa");
}

/// Whether two of the features may lack one each in the kind (o) of A_2. Each is in
/// feature_lists(), where `P/a/Pa` stands for `Pa/a/P`.
inline bool two_may_lack(const std::vector<std::string_view>& features) {
    const auto lacks_at_x_1 = [](std::string_view feature) { // where v' . x_1 = 0
        return feature == "P/a/Pa" || feature == "P/P/P" || feature == "Pa/a/Pa" ||
               feature == "Pa/Pa/Pa";
    };
    for (std::size_t i = 0; i < features.size(); ++i)
        for (std::size_t j = 0; j < features.size(); ++j)
            if (i != j && lacks_at_x_1(features[i]) && is_in_last_four_rows(features[j]))
                return true;
    return false;
}

/// Whether the other features are as Theorem S (a) asks, for one hidden point.
inline bool admits_one(const HiddenPoints& hidden, const FeatureLists& lists) {
    if (hidden.t_2 == 0 && two_may_lack(lists.features)) return false;
    return hidden.t_3 != 0 || !two_may_lack(lists.mirrored);
}

/// Whether a feature of feature_lists() is in the first three rows.
inline bool is_in_first_three_rows(std::string_view feature) {
    return feature != "P/P/P" && !is_in_last_four_rows(feature);
}

/// Whether the other features are as Theorem S (b) asks, for `a/P/a` and `a/a/P`.
inline bool admits_one_of_each(const FeatureLists& lists) {
    const auto simple = std::ranges::count_if(lists.features, is_in_first_three_rows);
    const bool one_other = static_cast<std::size_t>(simple) + 1 >= lists.features.size();
    return one_other && !two_may_lack(lists.features) && !two_may_lack(lists.mirrored);
}

/// Whether the other features are as Theorem S (c) asks, for any two hidden points.
inline bool admits_two(const HiddenPoints& hidden, const FeatureLists& lists) {
    const auto has = [&](std::string_view wanted) {
        return std::ranges::find(lists.features, wanted) != lists.features.end();
    };
    if (!std::ranges::all_of(lists.features, is_in_first_three_rows)) return false;
    if (hidden.t_2 != 0 && !has("P/Pa/a")) return true;
    if (hidden.t_3 != 0 && !has("P/a/Pa")) return true;
    return !has("P/Pa/a") && !has("P/a/Pa");
}

/// Whether they are as Theorem S (d) asks, for three hidden points: all of weight 1.
inline bool admits_three(const HiddenPoints& hidden, const FeatureLists& lists) {
    const auto has_weight_1 = [](std::string_view feature) {
        return checker::features[checker::index_of(feature)].weight() == 1;
    };
    return hidden.t_2 != 0 && hidden.t_3 != 0 && std::ranges::all_of(lists.features, has_weight_1);
}

/// Whether Theorem S speaks of these hidden points and other features, if they avoid all strata.
inline bool admits(const HiddenPoints& hidden, const FeatureLists& lists) {
    if (hidden.number() == 1) return admits_one(hidden, lists);
    if (hidden.number() == 3) return admits_three(hidden, lists);
    if (hidden.number() != 2) return false;
    const bool one_of_each = hidden.t_2 == 1 && hidden.t_3 == 1;
    return (one_of_each && admits_one_of_each(lists)) || admits_two(hidden, lists);
}

/// The upper bound by Theorem S on the degree of problems with a signature, of which view 1 sees
/// all points but one to three; none if the theorem does not speak of it.
inline std::optional<std::int64_t> hidden_bound_in_view_1(const checker::Signature& signature) {
    const HiddenPoints hidden = hidden_points(signature);
    const unsigned weight = weight_with_classes(signature) + hidden.number();
    if (hidden.number() == 0 || weight != checker::camera_unknowns) return std::nullopt;
    if (!admits(hidden, feature_lists(signature))) return std::nullopt;
    if (!avoids_the_boundary(signature)) return std::nullopt;
    return degree_of(cycle_of(signature) * cycle_of(hidden));
}

/// The smallest upper bound by Theorem S, whichever view comes first.
inline std::optional<std::int64_t> hidden_bound_by_theorem(const checker::Signature& signature) {
    std::optional<std::int64_t> smallest;
    std::set<checker::Signature> seen;
    for (const checker::FeatureMap& map : checker::relabelings) {
        checker::Signature image{};
        for (std::size_t i = 0; i < checker::feature_count; ++i)
            image[i] = signature[map[i]];
        if (!seen.insert(merged(image)).second) continue;
        const auto found = hidden_bound_in_view_1(merged(image));
        if (found && (!smallest || *found < *smallest)) smallest = found;
    }
    return smallest;
}

/// The constraint classes that arise where one view hands a point over to another, as in Theorem X:
/// two views share four points or more, and `P/a/a` of the one becomes `a/P/a` of the other.
inline std::set<checker::Signature> handed_over(const checker::Signature& signature) {
    constexpr checker::Views pair = checker::view_pairs[0]; // the views 1 and 2
    const std::size_t of_view_1 = checker::index_of("P/a/a"),
                      of_view_2 = checker::index_of("a/P/a");
    std::set<checker::Signature> found;
    for (const checker::FeatureMap& map : checker::relabelings) {
        checker::Signature image{};
        for (std::size_t i = 0; i < checker::feature_count; ++i)
            image[checker::exchanged(i)] += signature[map[i]];
        if (image[of_view_1] == 0 || checker::shared_points(image, pair) < 4) continue;
        --image[of_view_1];
        ++image[of_view_2];
        found.insert(checker::constraint_class(image));
    }
    return found;
}

/// All constraint classes that so arise of a class, one after another, and itself.
inline std::set<checker::Signature> of_equal_degree(const checker::Signature& constraint_class) {
    std::set<checker::Signature> found{constraint_class};
    std::vector<checker::Signature> open{constraint_class};
    while (!open.empty()) {
        const checker::Signature next = open.back();
        open.pop_back();
        for (const checker::Signature& other : handed_over(next))
            if (found.insert(other).second) open.push_back(other);
    }
    return found;
}

} // namespace proofs
