// Problems in general (FORMAT.md, section 13): points and lines, which points lie on which lines,
// and which views see them. Here points, lines and views are numbered from 0.
#pragma once

#include <bit>
#include <cstddef>
#include <optional>
#include <vector>

namespace checker::general {
inline constexpr unsigned most_views = 12;

/// A set of views: 0b001 is view 1, 0b110 are the views 2 and 3.
using Views = unsigned;
using Indices = std::vector<std::size_t>;

inline bool has_view(Views views, unsigned view) {
    return (views >> view & 1) != 0;
}

struct Point {
    Views seen_by = 0;
    Indices lines{}; // through it
};

struct Line {
    Views seen_by = 0;
    Indices points{}; // on it, ascending
};

struct Problem {
    bool projective = false; // cameras; else calibrated
    Views views = 0;         // all that there are
    std::vector<Point> points{};
    std::vector<Line> lines{};
};

/// How many points on the line have a smaller number than this one, and are seen by the view.
std::size_t earlier_points(const Problem& problem, std::size_t line, std::size_t point,
                           std::optional<unsigned> view = {});

/// The carrier of a point; none if the point is free.
std::optional<std::size_t> carrier(const Problem& problem, std::size_t point);

/// How many more points fix the line, beside the points on it: two, one or none.
std::size_t own_points(const Line& line);

/// Whether each view sees all points and lines.
bool all_views_see_all(const Problem& problem);

/// Why the problem does not conform; empty if it does.
const char* violation(const Problem& problem);

/// The dimension of all images less that of scenes and cameras: 0 if the problem is balanced.
int surplus(const Problem& problem);
} // namespace checker::general
