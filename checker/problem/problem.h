// A problem (FORMAT.md, sections 1 and 13): points and lines, which points lie on which lines,
// which views see them, and which cameras the views are from. Points, lines and views are numbered
// from 0.
#pragma once

#include "checker/cameras/camera_model.h"
#include "checker/problem/features.h"

#include <map>
#include <optional>
#include <vector>

namespace checker {
inline constexpr unsigned most_views = 12;

using Indices = std::vector<std::size_t>;

struct Point {
    Views seen_by = 0;
    Indices lines{}; // through it
};

struct Line {
    Views seen_by = 0;
    Indices points{}; // on it, ascending
};

struct Problem {
    const CameraModel* cameras = &calibrated_cameras;
    Views views = 0; // all that there are
    std::vector<Point> points{};
    std::vector<Line> lines{};

    int view_count() const { return std::popcount(views); }
};

/// Adds a feature: a point with lines through it, or a free line. Its capital letters name lines
/// that the problem has already if `shared` has their numbers.
void add_feature(Problem& problem, const Feature& feature, std::map<char, std::size_t>& shared);

/// The problem of one feature, in this number of views.
Problem problem_of(const Feature& feature, unsigned views);

/// The dimension of the cameras of the problem up to motions of space: the columns that they have
/// in the Jacobian.
int camera_columns(const Problem& problem);

/// How many points on the line have a smaller number than this one, and are seen by the view.
std::size_t earlier_points(const Problem& problem, std::size_t line, std::size_t point,
                           std::optional<unsigned> view = {});

/// The carrier of a point; none if the point is free.
std::optional<std::size_t> carrier(const Problem& problem, std::size_t point);

/// How many more points fix the line, beside the points on it: two, one or none.
std::size_t own_points(const Line& line);

/// What fixes a scene: its points that have no carrier, those that have one, and the own points of
/// its lines.
struct SceneParts {
    std::size_t free = 0;
    std::size_t carried = 0;
    std::size_t of_lines = 0;
};

SceneParts scene_parts(const Problem& problem);

/// Whether each view sees all points and lines.
bool all_views_see_all(const Problem& problem);

/// Why the problem does not conform; empty if it does.
const char* violation(const Problem& problem);

/// How many columns so many cameras of a kind have in J: the dimension D of FORMAT.md.
int columns_of(const CameraModel& cameras, int views);

/// The dimension of the images in these views.
int image_dimension(const Problem& problem, Views views);

/// The dimension of all images less that of scenes and cameras: 0 if the problem is balanced.
int surplus(const Problem& problem);
} // namespace checker
