#include "prover/reasons/part.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace plprove {

bool is_in(const std::vector<int>& ascending, int number) {
    return std::ranges::binary_search(ascending, number);
}

std::vector<int> united(const std::vector<int>& a, const std::vector<int>& b) {
    std::vector<int> all;
    std::ranges::set_union(a, b, std::back_inserter(all));
    return all;
}

Subproblem whole(const Problem& problem) {
    Subproblem part{all_views(problem.views), {}, {}};
    part.points.resize(problem.points.size());
    part.lines.resize(problem.lines.size());
    std::iota(part.points.begin(), part.points.end(), 0);
    std::iota(part.lines.begin(), part.lines.end(), 0);
    return part;
}

Problem problem_of(const Problem& problem, const Subproblem& part) {
    std::vector<int> views;
    for (int view = 0; view < problem.views; ++view)
        if (contains(part.views, view)) views.push_back(view);
    const auto seen_in_part = [&](ViewSet seen) {
        ViewSet result = 0;
        for (std::size_t i = 0; i < views.size(); ++i)
            if (contains(seen, views[i])) result |= ViewSet{1} << i;
        return result;
    };
    Problem result{problem.cameras, static_cast<int>(views.size()), {}, {}};
    for (const int point : part.points)
        result.points.push_back(seen_in_part(problem.points[static_cast<std::size_t>(point)]));
    for (const int number : part.lines) {
        const Line& line = problem.lines[static_cast<std::size_t>(number)];
        Line kept{{}, seen_in_part(line.seen)};
        for (std::size_t i = 0; i < part.points.size(); ++i)
            if (contains(line, part.points[i])) kept.points.push_back(static_cast<int>(i));
        result.lines.push_back(kept);
    }
    return result;
}

bool is_part(const Problem& problem, const Subproblem& part) {
    std::vector<bool> points(problem.points.size(), true), lines(problem.lines.size(), true);
    const auto points_left = [&](const Line& line) {
        return std::ranges::count_if(
            line.points, [&](int point) { return points[static_cast<std::size_t>(point)]; });
    };
    const auto leave_out_some = [&] {
        bool changed = false;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const bool goes = lines[i] && !is_in(part.lines, static_cast<int>(i)) &&
                              points_left(problem.lines[i]) <= 2;
            if (goes) lines[i] = false;
            changed = changed || goes;
        }
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!points[i] || is_in(part.points, static_cast<int>(i))) continue;
            const auto through =
                std::ranges::count_if(lines_through(problem, static_cast<int>(i)), [&](int number) {
                    return lines[static_cast<std::size_t>(number)];
                });
            if (through > 2) continue;
            points[i] = false;
            changed = true;
        }
        return changed;
    };
    while (leave_out_some()) {
    }
    return std::ranges::count(points, true) == std::ssize(part.points) &&
           std::ranges::count(lines, true) == std::ssize(part.lines);
}

} // namespace plprove
