#include "checker/general_bounds/stability.h"

#include <algorithm>
#include <array>

namespace checker::general {
namespace {

/// A way in which a point or line can be special to a line or plane in space: how many conditions
/// that puts on the line or plane, and how much it counts.
struct Option {
    std::size_t conditions = 0;
    int count = 0;
};

using Options = std::vector<Option>;

Options of_point_and_plane(int pins) {
    Options options{{0, pins}};
    for (int b = 0; b <= std::min(pins, 2); ++b)
        options.push_back({1 + static_cast<std::size_t>(b), 2 + pins - std::min(pins - b, 2)});
    return options;
}

Options of_point_and_line(int pins) {
    Options options{{2, 2}};
    for (int j = 0; j <= std::min(pins, 2); ++j)
        options.push_back({static_cast<std::size_t>(j), std::max(j, pins - 2)});
    if (pins > 0) options.push_back({4, 3});
    return options;
}

/// The largest sum of counts if each feature has one of its options, with at most `conditions`
/// conditions in all: at most four.
int largest_count(const std::vector<Options>& features, std::size_t conditions) {
    std::array<int, 5> largest{}; // with at most 0, ..., 4 conditions
    for (const Options& options : features) {
        std::array<int, 5> next{};
        for (std::size_t total = 0; total < next.size(); ++total)
            for (const Option& option : options)
                if (option.conditions <= total)
                    next[total] =
                        std::max(next[total], largest[total - option.conditions] + option.count);
        largest = next;
    }
    return largest[conditions];
}

} // namespace

bool general_arrangements_are_stable(const Problem& problem) {
    std::vector<Options> to_planes, to_lines;
    for (const Point& point : problem.points) {
        const int pins = static_cast<int>(point.lines.size());
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
} // namespace checker::general
