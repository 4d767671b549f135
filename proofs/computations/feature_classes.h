// The classes of the features that Theorem R of proofs/relations.md speaks of (sections 1 and 7
// there). View 1 sees the points.
#pragma once

#include "checker/degrees/constraint_class.h"
#include "proofs/computations/blow_up.h"
#include "proofs/computations/boundary_strata.h"
#include "proofs/computations/camera_space.h"

#include <optional>
#include <string_view>
#include <vector>

namespace proofs {

/// The classes of section 1 and what they consist of, named as there.
struct FeatureClasses {
    Cycle k_2 = class_of(k2), k_3 = class_of(k3);
    Cycle T = class_of(xi) - class_of(e);              // P/a/a
    Cycle E_2 = 2 * class_of(h3) + k_3 - class_of(y3); // P/-/P
    Cycle E_3 = 2 * class_of(h2) + k_2 - class_of(y2); // P/P/-
    Cycle s_2 = class_of(xi) - 2 * class_of(h3) - k_2; // the centres 1 and 2 agree
    Cycle s_3 = class_of(xi) - 2 * class_of(h2) - k_3; // the centres 1 and 3 agree
    Cycle Y_2 = class_of(y2) - class_of(e);
    Cycle Y_3 = class_of(y3) - class_of(e);
    Cycle Z_2 = k_2 * (E_3 - k_2); // the epipolar line of an image point in view 2 is given
    Cycle Z_3 = k_3 * (E_2 - k_3); // the same in view 3
    Cycle S_2 = E_2 * T - Z_3;     // Pa/a/P
    Cycle S_3 = E_3 * T - Z_2;     // Pa/P/a
    Cycle Q = E_2 * E_3 * T - Z_2 * E_2 - Z_3 * E_3;                             // P/P/P
    Cycle L = T * T - k_2 * k_3 - s_2 * k_3 - s_3 * k_2 - Y_2 * k_2 - Y_3 * k_3; // a/a/a
    Cycle W_2 = S_2 * T - (k_2 + s_2) * k_3 * k_3 - (s_3 + Y_2) * k_2 * E_2;     // Pa/a/Pa
    Cycle W_3 = S_3 * T - (k_3 + s_3) * k_2 * k_2 - (s_2 + Y_3) * k_3 * E_3;     // Pa/Pa/a
    Cycle A = Q * T - k_2 * k_2 * k_3 * k_3 - s_2 * k_3 * k_3 * E_3 - s_3 * k_2 * k_2 * E_2;
};

/// What the proper transforms on the blow-up in (i) lack: a feature has there its class less x
/// times this. Section 9.
struct Corrections : FeatureClasses {
    Cycle v = 2 * class_of(b); // v . x_1 = 0
    Cycle z = T - v;           // T'(l_2, l_3) = 0
    Cycle f_2 = E_3 - v, f_3 = E_2 - v;
    Cycle line_2 = 2 * (class_of(h2) - class_of(b)) * (k_2 - class_of(y2)); // f_2 is a given line
    Cycle line_3 = 2 * (class_of(h3) - class_of(b)) * (k_3 - class_of(y3));
    Cycle of_S = v;
    Cycle of_Q = v * (T + E_2 + E_3 - k_2 - k_3 - class_of(x));
    Cycle of_L = z;
    Cycle of_W_2 = v * T + f_3 * z - line_3;
    Cycle of_W_3 = v * T + f_2 * z - line_2;
    Cycle of_A = of_Q * T + f_2 * f_3 * z - line_2 * f_3 - line_3 * f_2;
};

/// A feature, the one with the views 2 and 3 exchanged, and its class.
struct FeatureClass {
    std::string_view notation, mirrored;
    const Cycle &cycle, &correction;
};

inline std::vector<FeatureClass> feature_classes() {
    static const Corrections c;
    static const Cycle none;
    return {{"P/a/a", "P/a/a", c.T, none},           {"P/-/P", "P/P/-", c.E_2, none},
            {"P/P/-", "P/-/P", c.E_3, none},         {"P/a/Pa", "P/Pa/a", c.S_2, c.of_S},
            {"P/Pa/a", "P/a/Pa", c.S_3, c.of_S},     {"P/P/P", "P/P/P", c.Q, c.of_Q},
            {"a/a/a", "a/a/a", c.L, c.of_L},         {"Pa/a/Pa", "Pa/Pa/a", c.W_2, c.of_W_2},
            {"Pa/Pa/a", "Pa/a/Pa", c.W_3, c.of_W_3}, {"Pa/Pa/Pa", "Pa/Pa/Pa", c.A, c.of_A}};
}

/// The weight of the features of a signature that are in feature_classes(), together.
inline unsigned weight_with_classes(const checker::Signature& signature) {
    unsigned weight = 0;
    for (const FeatureClass& feature : feature_classes()) {
        const std::size_t index = checker::index_of(feature.notation);
        weight += signature[index] * checker::features[index].weight();
    }
    return weight;
}

/// Whether all features of a signature are in feature_classes(), of weight 11 together.
inline bool has_classes(const checker::Signature& signature) {
    return weight_with_classes(signature) == checker::camera_unknowns;
}

/// The product of the classes of all features in feature_classes().
inline Cycle cycle_of(const checker::Signature& signature) {
    Cycle product{{Monomial{}, 1}};
    for (const FeatureClass& feature : feature_classes()) {
        const unsigned count = signature[checker::index_of(feature.notation)];
        product = product * power(feature.cycle, count);
    }
    return product;
}

/// The degree of the product of the classes of all features.
inline std::int64_t product_of_classes(const checker::Signature& signature) {
    return degree_of(cycle_of(signature));
}

/// The degree of the same product on the blow-up in (i), less that on M.
inline std::int64_t excess_on_blow_up(const checker::Signature& signature) {
    Cycle product{{Monomial{}, 1}}, proper = product;
    for (const FeatureClass& feature : feature_classes()) {
        const unsigned count = signature[checker::index_of(feature.notation)];
        product = product * power(feature.cycle, count);
        proper = proper * power(feature.cycle - class_of(x) * feature.correction, count);
    }
    return degree_on_blow_up(divided_by_x(proper - product));
}

/// The features of a signature, each as often as it occurs; `mirrored` with the views 2 and 3
/// exchanged.
struct FeatureLists {
    std::vector<std::string_view> features, mirrored;
};

inline FeatureLists feature_lists(const checker::Signature& signature) {
    FeatureLists lists;
    for (const FeatureClass& feature : feature_classes()) {
        const unsigned count = signature[checker::index_of(feature.notation)];
        lists.features.insert(lists.features.end(), count, feature.notation);
        lists.mirrored.insert(lists.mirrored.end(), count, feature.mirrored);
    }
    return lists;
}

/// Whether the features avoid all strata, as Proposition R8 asks.
inline bool avoids_the_boundary(const checker::Signature& signature) {
    const auto [features, mirrored] = feature_lists(signature);
    return strata_in_the_way(features).empty() && strata_in_the_way(mirrored).empty();
}

/// How many common points at the boundary the product of the classes counts at least, if all are
/// isolated, as Proposition R14 asks.
inline std::optional<unsigned> points_at_the_boundary(const checker::Signature& signature) {
    const auto [features, mirrored] = feature_lists(signature);
    const auto points = isolated_points(features), of_mirrored = isolated_points(mirrored);
    if (!points || !of_mirrored) return std::nullopt;
    return points->in_ii + points->in_iv + of_mirrored->in_iv;
}

/// Whether generic data of the features may have common points in the stratum (i).
inline bool meets_stratum_i(const checker::Signature& signature) {
    return !meetings(boundary_strata[0], feature_lists(signature).features).empty();
}

/// The upper bound by Theorem R on the degree of problems with a signature of which view 1 sees all
/// points; none if the theorem does not speak of it.
inline std::optional<std::int64_t> bound_in_view_1(const checker::Signature& signature) {
    if (!has_classes(signature)) return std::nullopt;
    const auto points = points_at_the_boundary(signature);
    if (!points) return std::nullopt;
    const std::int64_t on_m = product_of_classes(signature);
    const bool meets_i = meets_stratum_i(signature);
    return on_m + (meets_i ? excess_on_blow_up(signature) : 0) - *points;
}

/// Its degree by Theorem R (a); none if the theorem does not speak of it.
inline std::optional<std::int64_t> degree_in_view_1(const checker::Signature& signature) {
    if (!has_classes(signature) || !avoids_the_boundary(signature)) return std::nullopt;
    return product_of_classes(signature);
}

/// The signature with each feature replaced by the one with the same constraint that
/// feature_classes() may have.
inline checker::Signature merged(const checker::Signature& signature) {
    checker::Signature result{};
    for (std::size_t i = 0; i < checker::feature_count; ++i) {
        std::size_t letter = checker::exchanged(i);
        const std::string_view notation = checker::features[letter].notation;
        if (notation == "Pa/a/P") letter = checker::index_of("P/a/Pa");
        if (notation == "Pa/P/a") letter = checker::index_of("P/Pa/a");
        result[letter] += signature[i];
    }
    return result;
}

/// What one of the two functions above gives, in whichever view sees all points; none if the
/// theorem does not speak of the signature.
template <typename InView1>
std::optional<std::int64_t> in_some_view(const checker::Signature& signature, InView1 in_view_1) {
    for (const checker::FeatureMap& map : checker::relabelings) {
        checker::Signature image{};
        for (std::size_t i = 0; i < checker::feature_count; ++i)
            image[i] = signature[map[i]];
        if (const auto found = in_view_1(merged(image))) return found;
    }
    return std::nullopt;
}

/// The degree by Theorem R (a).
inline std::optional<std::int64_t> degree_by_theorem(const checker::Signature& signature) {
    return in_some_view(signature, degree_in_view_1);
}

/// The upper bound by Theorem R, (a) or (b).
inline std::optional<std::int64_t> bound_by_theorem(const checker::Signature& signature) {
    return in_some_view(signature, bound_in_view_1);
}

} // namespace proofs
