// Names of points and lines in the model of a point-line problem.
#pragma once

#include "prover/problem/problem.h"

#include <bit>
#include <string>

namespace plprove {

/// A point of space: the texts of three homogeneous coordinates, and of the fourth.
struct ScenePoint {
    std::string vector;
    std::string weight; ///< "0" and "1" are left out where they can be
};

/// Neighbours that differ in nothing but their place: a list in the model.
struct FeatureGroup {
    std::string key; ///< the number of the feature
    int count = 1;

    /// How its names begin a statement, and go on in it.
    std::string list() const { return count == 1 ? "" : "[1.." + std::to_string(count) + "]"; }
    std::string item() const { return count == 1 ? "" : "[i]"; }
};

/// The number of a view in names.
inline std::string view_number(int view) {
    return std::to_string(view + 1);
}

inline bool seen_by_two(ViewSet views) {
    return std::popcount(views) == 2;
}

} // namespace plprove
