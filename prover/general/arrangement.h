// Point-line problems in general: calibrated or projective cameras, any number of views, lines with
// any number of points, and what each view sees. docs/notation.md says how they are written.
//
// A problem is a plain value. Its points are in an order of construction: a point is free (3
// parameters), or it lies on one line through two earlier points (1 parameter). All dimensions
// follow from this order (certs/FORMAT.md, section 13).
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

namespace plprove::general {

enum class CameraModel : std::uint8_t { calibrated, projective };

inline constexpr int most_views = 12;
inline constexpr int most_points = 100;
inline constexpr int most_lines = 100;

/// A set of views: bit v stands for view v + 1.
using ViewSet = std::uint32_t;

/// Whether the set contains view `view`, counted from 0.
constexpr bool contains(ViewSet views, int view) {
    return (views >> view & 1U) != 0;
}

/// The set of the first `views` views.
constexpr ViewSet all_views(int views) {
    return (ViewSet{1} << views) - 1;
}

/// A line: the points on it, ascending, and the views that see it.
struct Line {
    std::vector<int> points;
    ViewSet seen = 0;
    auto operator<=>(const Line&) const = default;
};

/// Points and lines in space, and the views that see them. Two lines share at most one point. A
/// view that sees two points of a line sees the line; a view that sees two lines of a point sees
/// the point.
struct Problem {
    CameraModel model = CameraModel::calibrated;
    int views = 0;
    std::vector<ViewSet> points; ///< of each point, the views that see it
    std::vector<Line> lines;
    auto operator<=>(const Problem&) const = default;
};

/// Whether the line contains the point.
bool contains(const Line& line, int point);

/// The numbers of the lines through the point.
std::vector<int> lines_through(const Problem& problem, int point);

/// Of the line's points, those that view `view` sees.
std::vector<int> seen_points(const Problem& problem, const Line& line, int view);

/// The line through `point` on which two earlier points lie; nothing for a free point. Assumes the
/// order of construction.
std::optional<int> carrier(const Problem& problem, int point);

/// How many more points fix the line, beside the points on it: two, one or none.
int own_points(const Line& line);

/// Whether the points are in an order of construction: each lies on at most one line with two
/// earlier points.
bool is_constructible_in_order(const Problem& problem);

/// The same problem with its points in an order of construction; the given order, if it is one.
/// Nothing if there is none.
std::optional<Problem> in_order_of_construction(const Problem& problem);

/// Parameters of the points and lines in space.
int dimension_in_space(const Problem& problem);

/// Parameters of what view `view` sees.
int dimension_in_view(const Problem& problem, int view);

/// The sum of dimension_in_view over all views.
int dimension_in_views(const Problem& problem);

/// Parameters of `views` cameras, up to the motions of space that change no image: 6m - 7
/// calibrated, 11m - 15 projective. Assumes at least two views.
int camera_dimension(CameraModel model, int views);

/// Whether the images put one constraint for each parameter of cameras and scene.
bool is_balanced(const Problem& problem);

} // namespace plprove::general
