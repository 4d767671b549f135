// Classes by their features, and the upper bounds that theorems give them.
#pragma once

#include "checker/bounds/degree_bounds.h"
#include "checker/degrees/constraint_class.h"
#include "tests/support/all_classes.h"

using Features = std::map<std::string_view, unsigned>;

/// The number of the label class of these features. Checks that the class is minimal, and that
/// theorems alone give it this upper bound, whichever of its signatures asks.
inline std::size_t class_with_bound(const Features& features, int bound) {
    const checker::Signature signature = signature_of(features);
    const std::size_t number =
        checker::number_of(all_classes(), checker::largest_relabeled(signature));
    CHECK(checker::obstruction(signature).minimal());
    std::vector<bool> minimal(all_classes().representatives.size());
    minimal[number] = true;
    const checker::DegreeTable table = checker::combine(all_classes(), minimal, {}, {});
    for (const checker::FeatureMap& map : checker::relabelings) {
        const auto known = table.find(checker::constraint_class(permuted(signature, map)));
        REQUIRE(known != table.end());
        REQUIRE(known->second.at_most);
        CHECK(known->second.at_most->by_theorem());
        CHECK(known->second.at_most->solutions == static_cast<std::size_t>(bound));
    }
    return number;
}
