// The order of the points of a problem, as certs/FORMAT.md, section 13, item 4, wants it.
#pragma once

#include "prover/problem/problem.h"

#include <algorithm>

/// Whether each point lies on at most one line with two earlier points.
inline bool is_constructible_in_order(const plprove::Problem& problem) {
    for (int point = 0; point < static_cast<int>(problem.points.size()); ++point) {
        const auto carries = [&](const plprove::Line& line) {
            const auto earlier = [&](int other) { return other < point; };
            return std::ranges::count(line.points, point) > 0 &&
                   std::ranges::count_if(line.points, earlier) >= 2;
        };
        if (std::ranges::count_if(problem.lines, carries) > 1) return false;
    }
    return true;
}
