// Constraint classes (FORMAT.md, section 9): problems whose cameras satisfy the same equations, and
// which therefore have the same camera-degree (proofs/problems.md, section 8).
#pragma once

#include "checker/problem/classes.h"

namespace checker {
/// Of a feature like `Pab/b/a`, where one view sees a point with two pins that one other view each
/// sees, `P/a/a`; of other features, the same.
inline std::size_t exchanged(std::size_t index) {
    const Feature& feature = features[index];
    const bool one_view = std::popcount(feature.point) == 1;
    if (feature.pins != 2 || !one_view) return index;
    return index_of(Feature{.point = feature.point, .pin = {all_views ^ feature.point}, .pins = 1});
}

/// The signature that stands for a balanced signature's constraint class.
inline Signature constraint_class(const Signature& signature) {
    Signature merged{};
    for (std::size_t i = 0; i < feature_count; ++i)
        merged[exchanged(i)] += signature[i];
    return largest_swapped(merged);
}
} // namespace checker
