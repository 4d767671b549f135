// Which points are joined, directly or by others.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace plprove {

class JoinedPoints {
public:
    explicit JoinedPoints(std::size_t points) : group_(points) {
        std::iota(group_.begin(), group_.end(), 0);
    }

    /// Joins two points; false if they were joined before.
    bool join(int a, int b) {
        const int of_a = group_[static_cast<std::size_t>(a)];
        const int of_b = group_[static_cast<std::size_t>(b)];
        std::ranges::replace(group_, of_a, of_b);
        return of_a != of_b;
    }

private:
    std::vector<int> group_; // of each point, by a number
};

} // namespace plprove
