#include "checker/family/family.h"

#include <algorithm>

namespace checker {
static std::vector<Problem> list_of(const Problems& problems) {
    std::vector<Problem> list;
    problems.for_each([&](const Problem& problem, auto) { list.push_back(problem); });
    return list;
}

static void put(Problem& problem, std::size_t point, std::size_t line) {
    problem.lines[line].points.push_back(point);
    problem.points[point].lines.push_back(line);
}

static bool have_common_line(const Problem& problem, std::size_t p, std::size_t q) {
    const auto holds_q = [&](std::size_t n) {
        return std::ranges::count(problem.lines[n].points, q) > 0;
    };
    return std::ranges::any_of(problem.points[p].lines, holds_q);
}

/// Adds the problems that one more point makes of this one, whose lines have three points or more.
/// By item 4 it is free, on a line, or on the line through two points that had none.
static void add_point(Problems& found, Problem problem) {
    const std::size_t point = problem.points.size();
    problem.points.emplace_back();
    found[problem] = {};
    for (std::size_t n = 0; n < problem.lines.size(); ++n) {
        Problem on_line = problem;
        put(on_line, point, n);
        found[on_line] = {};
    }
    for (std::size_t q = 0; q < point; ++q)
        for (std::size_t p = 0; p < q; ++p) {
            if (have_common_line(problem, p, q)) continue;
            Problem on_new_line = problem;
            on_new_line.lines.emplace_back();
            for (const std::size_t each : {p, q, point})
                put(on_new_line, each, problem.lines.size());
            found[on_new_line] = {};
        }
}

/// By the number of points, up to 8: how points lie on lines with three points or more.
static std::vector<std::vector<Problem>> arrangements() {
    std::vector<std::vector<Problem>> all{{Problem{}}};
    for (int points = 1; points <= 8; ++points) {
        Problems found;
        for (const Problem& problem : all.back())
            add_point(found, problem);
        all.push_back(list_of(found));
    }
    return all;
}

/// Adds the problems with `pins` pins more.
static void add_with_pins(Problems& found, const Problem& problem, int pins) {
    std::vector<Problem> with_pins{problem};
    for (; pins > 0; --pins) {
        Problems one_more;
        for (Problem& before : with_pins)
            for (std::size_t p = 0; p < problem.points.size(); ++p) {
                Problem after = before;
                after.lines.push_back({.seen_by = problem.views});
                put(after, p, before.lines.size());
                one_more[after] = {};
            }
        with_pins = list_of(one_more);
    }
    for (const Problem& each : with_pins)
        found[each] = {};
}

/// Adds the balanced problems with these points in `views` views, which all see everything. In
/// two views lines are seen for nothing; in more a free line adds 2 (m - 2) to the surplus, a pin
/// m - 2.
static void add_balanced(Problems& found, Problem problem, int views) {
    problem.views = (1U << views) - 1;
    for (Point& point : problem.points)
        point.seen_by = problem.views;
    for (Line& line : problem.lines)
        line.seen_by = problem.views;
    const int missing = -surplus(problem);
    if (missing == 0) found[problem] = {};
    if (missing <= 0 || views == 2 || missing % (views - 2) != 0) return;
    for (int pins = missing / (views - 2); pins >= 0; pins -= 2) {
        add_with_pins(found, problem, pins);
        problem.lines.push_back({.seen_by = problem.views});
    }
}

std::string_view family_name(const CameraModel& cameras) {
    return &cameras == &calibrated_cameras ? "plmp" : cameras.name;
}

const CameraModel* cameras_of_family(std::string_view name) {
    for (const CameraModel* cameras : camera_models())
        if (family_name(*cameras) == name) return cameras;
    return nullptr;
}

Problems family(const CameraModel& cameras) {
    const int of_two = columns_of(cameras, 2);
    const std::vector<std::vector<Problem>> by_points = arrangements();
    Problems found;
    for (std::size_t points = 0; points < by_points.size(); ++points)
        for (int views = 2; views <= static_cast<int>(most_views); ++views) {
            if (views == 2 && of_two > columns_of(projective_cameras, 2)) continue;
            if (views > 3 && static_cast<int>(points) >= of_two) continue;
            for (Problem problem : by_points[points]) {
                problem.cameras = &cameras;
                add_balanced(found, problem, views);
            }
        }
    return found;
}
} // namespace checker
