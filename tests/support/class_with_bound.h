// Classes by their features, and the upper bounds that theorems give them.
#pragma once

#include "checker/problem.h"

#include <doctest/doctest.h>

#include <map>
#include <string_view>

using Features = std::map<std::string_view, unsigned>;

/// The number of the label class of these features. Checks that each of its signatures has this
/// upper bound.
inline std::size_t class_with_bound(const Features& features, int bound) {
    static const checker::Classification classes = checker::classify();
    checker::Signature signature{};
    for (std::size_t i = 0; i < checker::feature_count; ++i)
        if (const auto found = features.find(checker::features[i].notation);
            found != features.end())
            signature[i] = found->second;
    for (const checker::Map& map : checker::relabelings) {
        checker::Signature image{};
        for (std::size_t i = 0; i < checker::feature_count; ++i)
            image[i] = signature[map[i]];
        CHECK(checker::bound_by_theorem(image) == static_cast<unsigned>(bound));
    }
    return checker::class_of(classes, signature, false);
}
