// Where paths lead, and the next ones from there or in their place.
#pragma once

#include <optional>
#include <utility>
#include <vector>

namespace plprove {

/// A path that lost its solution has no end.
template <class Point>
using PathEnds = std::vector<std::optional<Point>>;

/// The starts of the paths that have no end, and their indices.
template <class Point>
std::pair<std::vector<Point>, std::vector<std::size_t>>
without_end(const std::vector<Point>& starts, const PathEnds<Point>& ends) {
    std::pair<std::vector<Point>, std::vector<std::size_t>> result;
    for (std::size_t i = 0; i < starts.size(); ++i)
        if (!ends[i]) {
            result.first.push_back(starts[i]);
            result.second.push_back(i);
        }
    return result;
}

/// Follows the paths that have no end once more, by a function from starts to ends.
template <class Point, class Follow>
void fill(PathEnds<Point>& ends, const std::vector<Point>& starts, Follow follow_again) {
    const auto [open, indices] = without_end(starts, ends);
    const PathEnds<Point> again = follow_again(open);
    for (std::size_t k = 0; k < indices.size(); ++k)
        ends[indices[k]] = again[k];
}

/// Follows the paths that have an end further, by a function from starts to ends.
template <class Point, class Follow>
PathEnds<Point> follow_on(const PathEnds<Point>& ends, Follow follow_further) {
    std::vector<Point> starts;
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < ends.size(); ++i)
        if (ends[i]) {
            starts.push_back(*ends[i]);
            indices.push_back(i);
        }
    const PathEnds<Point> further = follow_further(starts);
    PathEnds<Point> result(ends.size());
    for (std::size_t k = 0; k < indices.size(); ++k)
        result[indices[k]] = further[k];
    return result;
}

} // namespace plprove
