// Why a problem is not minimal at any point (FORMAT.md, section 4).
#pragma once

#include "checker/problem/classes.h"

namespace checker {
/// The number of points that both views of a pair see.
inline unsigned shared_points(const Signature& signature, Views pair) {
    unsigned points = 0;
    for (std::size_t i = 0; i < feature_count; ++i)
        if ((features[i].point & pair) == pair) points += signature[i];
    return points;
}

struct Obstruction {
    std::array<unsigned, 3> excess{}; // of the pairs 12, 13, 23
    unsigned star = 0;                // S

    unsigned epipolar() const { return excess[0] + excess[1] + excess[2]; } // E
    unsigned deficiency() const { return std::max(epipolar(), star); }
    bool minimal() const { return deficiency() == 0; }
};

/// S of a balanced signature. It has at most one star: two weigh 12 at least.
inline unsigned star_obstruction(const Signature& signature) {
    unsigned pins = 0;      // of the star
    bool free_line = false; // whether there is one
    Views seen = 0;         // the views that see anything of another feature
    for (std::size_t i = 0; i < feature_count; ++i) {
        if (signature[i] == 0) continue;
        const bool star = features[i].pins >= 3;
        if (star) pins = features[i].pins;
        if (!star) seen |= features[i].views;
        free_line |= features[i].free_line;
    }
    if (pins == 7) return 1;
    if (pins == 6 && free_line) return 1;
    return pins >= 3 && seen != all_views ? 1 : 0;
}

/// The obstruction of a balanced signature.
inline Obstruction obstruction(const Signature& signature) {
    Obstruction found{.star = star_obstruction(signature)};
    for (std::size_t p = 0; p < view_pairs.size(); ++p) {
        const unsigned shared = shared_points(signature, view_pairs[p]);
        found.excess[p] = shared > 5 ? shared - 5 : 0;
    }
    return found;
}
} // namespace checker
