#include "checker/problem/problem.h"

#include <algorithm>

namespace checker {
void add_feature(Problem& problem, const Feature& feature, std::map<char, std::size_t>& shared) {
    const std::size_t point = problem.points.size();
    if (!feature.free_line) problem.points.push_back({.seen_by = feature.point});
    for (std::size_t i = 0; i < feature.pins; ++i) {
        const char letter = feature.letter[i];
        std::size_t line = problem.lines.size();
        if (is_capital(letter)) line = shared.try_emplace(letter, line).first->second;
        if (line == problem.lines.size()) problem.lines.push_back({.seen_by = feature.pin[i]});
        if (feature.free_line) continue;
        problem.lines[line].points.push_back(point);
        problem.points[point].lines.push_back(line);
    }
}

Problem problem_of(const Feature& feature, unsigned views) {
    Problem problem{.views = (1U << views) - 1};
    std::map<char, std::size_t> shared;
    add_feature(problem, feature, shared);
    return problem;
}

int columns_of(const CameraModel& cameras, int views) {
    return static_cast<int>(cameras.shared) + cameras.unknowns_of_second +
           cameras.unknowns * (views - 2);
}

int camera_columns(const Problem& problem) {
    return columns_of(*problem.cameras, problem.view_count());
}

std::size_t earlier_points(const Problem& problem, std::size_t line, std::size_t point,
                           std::optional<unsigned> view) {
    std::size_t count = 0;
    for (const std::size_t other : problem.lines[line].points) {
        const bool is_seen = !view || has_view(problem.points[other].seen_by, *view);
        if (other < point && is_seen) ++count;
    }
    return count;
}

std::optional<std::size_t> carrier(const Problem& problem, std::size_t point) {
    for (const std::size_t line : problem.points[point].lines)
        if (earlier_points(problem, line, point) >= 2) return line;
    return std::nullopt;
}

std::size_t own_points(const Line& line) {
    return 2 - std::min<std::size_t>(2, line.points.size());
}

SceneParts scene_parts(const Problem& problem) {
    SceneParts parts;
    for (std::size_t p = 0; p < problem.points.size(); ++p)
        ++(carrier(problem, p) ? parts.carried : parts.free);
    for (const Line& line : problem.lines)
        parts.of_lines += own_points(line);
    return parts;
}

/// Whether two lines share two points.
static bool share_two_points(const Line& a, const Line& b) {
    const auto is_on_b = [&](std::size_t p) { return std::ranges::count(b.points, p) > 0; };
    return std::ranges::count_if(a.points, is_on_b) >= 2;
}

bool all_views_see_all(const Problem& problem) {
    const auto is_seen = [&](const auto& thing) { return thing.seen_by == problem.views; };
    return std::ranges::all_of(problem.points, is_seen) &&
           std::ranges::all_of(problem.lines, is_seen);
}

const char* violation(const Problem& problem) {
    std::vector<const Line*> shared; // by points: only such lines may share two
    for (const Line& line : problem.lines)
        if (line.points.size() >= 2) shared.push_back(&line);
    for (const Line* a : shared)
        for (const Line* b : shared)
            if (a != b && share_two_points(*a, *b)) return "two lines to share at most one point";
    for (const Line& line : problem.lines)
        for (const std::size_t p : line.points)
            for (const std::size_t q : line.points) {
                const Views both = problem.points[p].seen_by & problem.points[q].seen_by;
                if (p != q && (both & ~line.seen_by) != 0)
                    return "a view that sees two points of a line to see the line";
            }
    // Item 3, that a view which sees two lines of a point sees the point, is part of the spelling.
    for (std::size_t p = 0; p < problem.points.size(); ++p) {
        const auto holds_two = [&](std::size_t line) {
            return earlier_points(problem, line, p) >= 2;
        };
        if (std::ranges::count_if(problem.points[p].lines, holds_two) > 1)
            return "each point to lie on at most one line with two earlier points";
    }
    return "";
}

int image_dimension(const Problem& problem, Views views) {
    int images = 0;
    for (const Point& point : problem.points)
        images += 2 * std::popcount(point.seen_by & views);
    for (const Line& line : problem.lines) {
        images += 2 * std::popcount(line.seen_by & views);
        for (const std::size_t p : line.points)
            images -= std::popcount(line.seen_by & problem.points[p].seen_by & views);
    }
    return images;
}

int surplus(const Problem& problem) {
    const auto [free, carried, of_lines] = scene_parts(problem);
    const int space = static_cast<int>(3 * free + carried + 2 * of_lines);
    return image_dimension(problem, problem.views) - space - camera_columns(problem);
}
} // namespace checker
