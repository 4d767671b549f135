// Parts of a problem: some of its views, points and lines.
#pragma once

#include "prover/problem/problem.h"

#include <algorithm>
#include <bit>
#include <vector>

namespace plprove {

/// Some of a problem's views, points and lines.
struct Subproblem {
    ViewSet views = 0;
    std::vector<int> points; ///< ascending
    std::vector<int> lines;  ///< ascending
};

/// Whether the number is among these.
bool is_in(const std::vector<int>& ascending, int number);

/// All numbers that are in one of two ascending lists.
std::vector<int> united(const std::vector<int>& a, const std::vector<int>& b);

/// What views say of a line, beyond the two numbers of its direction.
inline int conditions_in(ViewSet views) {
    return std::max(0, std::popcount(views) - 2);
}

/// The whole problem as a part of itself.
Subproblem whole(const Problem& problem);

/// The problem that consists of the part. Its points and lines are numbered anew.
Problem problem_of(const Problem& problem, const Subproblem& part);

/// Whether the part arises by leaving out points and lines one after the other, as FORMAT.md wants
/// it.
bool is_part(const Problem& problem, const Subproblem& part);

} // namespace plprove
