#include "checker/general_bounds/shared_points.h"

#include <algorithm>

namespace checker {
/// Whether each line has at most one point.
static bool points_are_free(const Problem& problem) {
    return std::ranges::all_of(problem.lines,
                               [](const Line& line) { return line.points.size() <= 1; });
}

/// Whether neither the point nor a line through it is seen by the view.
static bool is_missed(const Problem& problem, const Point& point, Views view) {
    return (point.seen_by & view) == 0 && std::ranges::all_of(point.lines, [&](std::size_t line) {
               return (problem.lines[line].seen_by & view) == 0;
           });
}

/// The problem without a point and the lines through it.
static Problem without_point(const Problem& problem, std::size_t dropped) {
    Problem rest{.cameras = problem.cameras, .views = problem.views};
    for (const Point& point : problem.points)
        if (&point != &problem.points[dropped]) rest.points.push_back({point.seen_by});
    for (const Line& line : problem.lines) {
        if (line.points == Indices{dropped}) continue;
        Line kept{line.seen_by};
        for (const std::size_t point : line.points) {
            kept.points.push_back(point < dropped ? point : point - 1);
            rest.points[kept.points.back()].lines.push_back(rest.lines.size());
        }
        rest.lines.push_back(kept);
    }
    return rest;
}

/// If the third view sees of the point no more than its only line, as one of the two others does:
/// this one does not see the point any more.
static std::optional<Problem> seen_once(const Problem& problem, std::size_t index, Views third) {
    const Point& point = problem.points[index];
    if ((point.seen_by & third) != 0 || point.lines.size() != 1) return std::nullopt;
    const Views of_line = problem.lines[point.lines[0]].seen_by;
    if ((of_line & third) == 0 || std::popcount(of_line) != 2) return std::nullopt;
    Problem rest = problem;
    rest.points[index].seen_by &= ~of_line;
    return rest;
}

/// One point less that two views share, if they share six.
static std::optional<Problem> with_five_shared_points(const Problem& problem, Views pair) {
    const Views third = problem.views & ~pair;
    Indices shared;
    for (std::size_t i = 0; i < problem.points.size(); ++i)
        if ((pair & ~problem.points[i].seen_by) == 0) shared.push_back(i);
    if (shared.size() != 6) return std::nullopt;
    for (const std::size_t i : shared)
        if (is_missed(problem, problem.points[i], third)) return without_point(problem, i);
    for (const std::size_t i : shared)
        if (auto rest = seen_once(problem, i, third)) return rest;
    return std::nullopt;
}

std::optional<Problem> calibrated_part(const Problem& problem) {
    if (problem.cameras->name != "shared-focal" || problem.view_count() != 3 ||
        !points_are_free(problem))
        return std::nullopt;
    for (const Views third : {1U, 2U, 4U})
        if (auto part = with_five_shared_points(problem, problem.views & ~third)) {
            part->cameras = &calibrated_cameras;
            return part;
        }
    return std::nullopt;
}
} // namespace checker
