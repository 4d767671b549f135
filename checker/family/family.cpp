#include "checker/family/family.h"

#include <algorithm>

namespace checker {
const Problem* find(const IsomorphismClasses& classes, const Problem& problem) {
    const auto place = classes.find(invariant(problem));
    if (place == classes.end()) return nullptr;
    const auto same = [&](const Problem& other) { return isomorphic(problem, other); };
    const auto found = std::ranges::find_if(place->second, same);
    return found == place->second.end() ? nullptr : &*found;
}

static void add(IsomorphismClasses& classes, Problem problem) {
    if (!find(classes, problem)) classes[invariant(problem)].push_back(std::move(problem));
}

static std::vector<Problem> list_of(const IsomorphismClasses& classes) {
    std::vector<Problem> list;
    for (const auto& [key, problems] : classes)
        list.insert(list.end(), problems.begin(), problems.end());
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
static void add_point(IsomorphismClasses& classes, Problem problem) {
    const std::size_t point = problem.points.size();
    problem.points.emplace_back();
    add(classes, problem);
    for (std::size_t n = 0; n < problem.lines.size(); ++n) {
        Problem on_line = problem;
        put(on_line, point, n);
        add(classes, on_line);
    }
    for (std::size_t q = 0; q < point; ++q)
        for (std::size_t p = 0; p < q; ++p) {
            if (have_common_line(problem, p, q)) continue;
            Problem on_new_line = problem;
            on_new_line.lines.emplace_back();
            for (const std::size_t each : {p, q, point})
                put(on_new_line, each, problem.lines.size());
            add(classes, on_new_line);
        }
}

/// By the number of points, up to 8: how points lie on lines with three points or more.
static std::vector<std::vector<Problem>> arrangements() {
    std::vector<std::vector<Problem>> all{{Problem{}}};
    for (int points = 1; points <= 8; ++points) {
        IsomorphismClasses classes;
        for (const Problem& problem : all.back())
            add_point(classes, problem);
        all.push_back(list_of(classes));
    }
    return all;
}

/// Adds the problems with `pins` pins more.
static void add_with_pins(IsomorphismClasses& classes, const Problem& problem, int pins) {
    std::vector<Problem> with_pins{problem};
    for (; pins > 0; --pins) {
        IsomorphismClasses one_more;
        for (Problem& before : with_pins)
            for (std::size_t p = 0; p < problem.points.size(); ++p) {
                Problem after = before;
                after.lines.push_back({.seen_by = problem.views});
                put(after, p, before.lines.size());
                add(one_more, after);
            }
        with_pins = list_of(one_more);
    }
    for (Problem& each : with_pins)
        add(classes, std::move(each));
}

/// Adds the balanced problems with these points in `views` views, which all see everything. In
/// two views lines are seen for nothing; in more a free line adds 2 (m - 2) to the surplus, a pin
/// m - 2.
static void add_balanced(IsomorphismClasses& classes, Problem problem, int views) {
    problem.views = (1U << views) - 1;
    for (Point& point : problem.points)
        point.seen_by = problem.views;
    for (Line& line : problem.lines)
        line.seen_by = problem.views;
    const int missing = -surplus(problem);
    if (missing == 0) add(classes, problem);
    if (missing <= 0 || views == 2 || missing % (views - 2) != 0) return;
    for (int pins = missing / (views - 2); pins >= 0; pins -= 2) {
        add_with_pins(classes, problem, pins);
        problem.lines.push_back({.seen_by = problem.views});
    }
}

IsomorphismClasses family(std::string_view name) {
    const CameraModel& cameras = name == "projective" ? projective_cameras : calibrated_cameras;
    const std::vector<std::vector<Problem>> by_points = arrangements();
    IsomorphismClasses classes;
    for (std::size_t points = 0; points < by_points.size(); ++points)
        for (int views = 2; views <= static_cast<int>(most_views); ++views) {
            if (&cameras == &projective_cameras && points >= 7 && views > 3) continue;
            for (Problem problem : by_points[points]) {
                problem.cameras = &cameras;
                add_balanced(classes, problem, views);
            }
        }
    return classes;
}
} // namespace checker
