// What two or three photos share: points and lines that somebody matched, some of them wrongly.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace plprove {

/// From normalised coordinates to pixels: (fx x + cx, fy y + cy).
struct PinholeIntrinsics {
    double fx = 1, fy = 1, cx = 0, cy = 0;

    Eigen::Vector2d normalised(const Eigen::Vector2d& pixel) const {
        return {(pixel.x() - cx) / fx, (pixel.y() - cy) / fy};
    }
};

/// Two points of an image line, in normalised coordinates.
struct Segment {
    Eigen::Vector2d begin, end;
};

/// What the views see of a point or a line; nothing where one does not see it.
using PointMatch = std::vector<std::optional<Eigen::Vector2d>>; ///< normalised coordinates
using LineMatch = std::vector<std::optional<Segment>>;

struct Matches {
    std::vector<PinholeIntrinsics> intrinsics; ///< one for each view
    std::vector<PointMatch> points;
    std::vector<LineMatch> lines;
    std::vector<std::vector<std::size_t>> lines_through; ///< of each point, ascending

    std::size_t views() const { return intrinsics.size(); }
};

/// How many views see it.
template <class Match>
std::size_t views_that_see(const Match& match) {
    std::size_t count = 0;
    for (const auto& sighting : match)
        count += sighting.has_value();
    return count;
}

/// Whether cameras can be tested by it: two views fix a point, so they test themselves, and a third
/// view tests a line that two views fix.
inline bool tests_cameras(const PointMatch& match) {
    return views_that_see(match) >= 2;
}
inline bool tests_cameras(const LineMatch& match) {
    return views_that_see(match) >= 3;
}

} // namespace plprove
