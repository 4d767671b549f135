// Why a balanced problem is not minimal, read off its signature (certs/FORMAT.md, section 4): too
// many points shared by a pair of views, or a star that lets a camera slide.
#pragma once

#include "prover/problem/signature.h"

namespace plprove {

/// The pairs of views 12, 13, 23, counted from 0.
inline constexpr std::array<std::array<int, 2>, 3> view_pairs{{{0, 1}, {0, 2}, {1, 2}}};

struct Obstruction {
    std::array<int, 3>
        excess{}; ///< max(0, m - 5) for the pairs 12, 13, 23; m: points that both views see
    int star = 0; ///< S: 0 or 1; 2 for a point with 8 pins, which is no feature of a class

    /// max(E, S): by how much the generic rank of the camera part falls short of 11.
    int deficiency() const;
};

/// The number of points that each of the pairs 12, 13, 23 of views shares; in two views only the
/// first exists.
std::array<int, 3> shared_points(const Features& problem);

/// E and S of a reduced, lifted problem. S has a meaning only where it is balanced.
Obstruction obstruction(const Features& problem);

} // namespace plprove
