#include "checker/general_bounds/stability.h"

#include <algorithm>
#include <array>

namespace checker {
namespace {

/// A way in which a point or line can be special to a line or plane in space: how many conditions
/// that puts on the line or plane, and how much it counts.
struct Position {
    std::size_t conditions = 0;
    int count = 0;
};

using Positions = std::vector<Position>;

Positions of_point_and_plane(int pins) {
    Positions positions{{0, pins}};
    for (int b = 0; b <= std::min(pins, 2); ++b)
        positions.push_back({1 + static_cast<std::size_t>(b), 2 + pins - std::min(pins - b, 2)});
    return positions;
}

Positions of_point_and_line(int pins) {
    Positions positions{{2, 2}};
    for (int j = 0; j <= std::min(pins, 2); ++j)
        positions.push_back({static_cast<std::size_t>(j), std::max(j, pins - 2)});
    if (pins > 0) positions.push_back({4, 3});
    return positions;
}

/// The largest sum of counts if each feature has one of its positions, with at most `conditions`
/// conditions in all: at most four.
int largest_count(const std::vector<Positions>& features, std::size_t conditions) {
    std::array<int, 5> largest{}; // with at most 0, ..., 4 conditions
    for (const Positions& positions : features) {
        std::array<int, 5> next{};
        for (std::size_t total = 0; total < next.size(); ++total)
            for (const Position& position : positions)
                if (position.conditions <= total)
                    next[total] = std::max(next[total],
                                           largest[total - position.conditions] + position.count);
        largest = next;
    }
    return largest[conditions];
}

} // namespace

bool general_arrangements_are_stable(const Problem& problem) {
    constexpr int most_pins = 4; // Lemma T4
    std::vector<Positions> to_planes, to_lines;
    for (const Point& point : problem.points) {
        const int pins = static_cast<int>(point.lines.size());
        if (pins > most_pins) return false;
        to_planes.push_back(of_point_and_plane(pins));
        to_lines.push_back(of_point_and_line(pins));
    }
    for (const Line& line : problem.lines) {
        if (!line.points.empty()) continue;
        to_planes.push_back({{0, 1}, {2, 2}});
        to_lines.push_back({{0, 0}, {1, 1}, {4, 2}});
    }
    return largest_count(to_planes, 3) <= 8 && largest_count(to_lines, 4) <= 5;
}
} // namespace checker
