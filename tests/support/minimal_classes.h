// Properties of classes that tests of degrees ask for.
#pragma once

#include "tests/support/all_classes.h"

/// Whether the class with this number is minimal.
inline bool is_minimal_class(std::size_t number) {
    return checker::obstruction(all_classes().representatives[number]).minimal();
}

/// Whether some two views share exactly five points.
inline bool has_five_shared_points(const checker::Signature& signature) {
    return std::any_of(
        checker::view_pairs.begin(), checker::view_pairs.end(),
        [&](checker::Views pair) { return checker::shared_points(signature, pair) == 5; });
}
