// Problems for projective cameras in which all views see everything, for tests.
#pragma once

#include "checker/problem/problem.h"

/// One in `views` views, with free lines, and a point with each of these numbers of pins.
inline checker::Problem visible_problem(unsigned views, const std::vector<std::size_t>& pins,
                                        std::size_t free_lines) {
    const checker::Views all = (1U << views) - 1;
    checker::Problem problem{
        .cameras = &checker::projective_cameras, .views = all, .points = {}, .lines = {}};
    for (const std::size_t of_point : pins) {
        checker::Point& point = problem.points.emplace_back();
        point.seen_by = all;
        for (std::size_t pin = 0; pin < of_point; ++pin) {
            point.lines.push_back(problem.lines.size());
            problem.lines.push_back({.seen_by = all, .points = {problem.points.size() - 1}});
        }
    }
    problem.lines.resize(problem.lines.size() + free_lines, {.seen_by = all, .points = {}});
    return problem;
}
