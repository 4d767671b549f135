// What is seen of a balanced problem of which neither a certificate nor a reason is found.
#pragma once

#include "prover/problem/problem.h"

#include <array>
#include <string>
#include <vector>

namespace plprove {

/// A balanced problem that looks as if it were not minimal, and no known reason says why: evidence,
/// no verdict. Its lines are in the order of its notation.
struct Undecided {
    Problem problem;
    int parameters = 0;         ///< of cameras and scene
    std::array<int, 3> ranks{}; ///< of the Jacobian, at random places
    /// What moves at the first of these places while no image changes and camera 1 rests.
    std::vector<int> moving_views{}, moving_points{}, moving_lines{};
};

/// Ranks and motions at three random places.
Undecided look_at(const Problem& problem);

/// The same in words.
std::string explanation(const Undecided& problem);

} // namespace plprove
