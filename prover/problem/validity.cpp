#include "prover/problem/validity.h"

#include "prover/problem/notation.h"

#include <algorithm>
#include <iterator>
#include <string>

namespace plprove {

namespace {

std::string point_name(int point) {
    return "point " + std::to_string(point + 1);
}

void refuse_common_points(const Line& one, const Line& other) {
    std::vector<int> common;
    std::ranges::set_intersection(one.points, other.points, std::back_inserter(common));
    if (common.size() < 2) return;
    throw NotationError(point_name(common[0]) + " and " + point_name(common[1]) +
                        " lie on two lines, but two lines share at most one point: give both "
                        "lines one letter");
}

void refuse_unseen_line(const Problem& problem, const Line& line) {
    for (int view = 0; view < problem.views; ++view) {
        const std::vector<int> seen = seen_points(problem, line, view);
        if (seen.size() < 2 || contains(line.seen, view)) continue;
        throw NotationError("view " + std::to_string(view + 1) + " sees " + point_name(seen[0]) +
                            " and " + point_name(seen[1]) +
                            ", so it sees the line through them: write its letter in view " +
                            std::to_string(view + 1));
    }
}

void refuse_unseen_point(const Problem& problem, int point) {
    for (int view = 0; view < problem.views; ++view) {
        if (contains(problem.points[static_cast<std::size_t>(point)], view)) continue;
        int seen_lines = 0;
        for (const int number : lines_through(problem, point))
            seen_lines +=
                contains(problem.lines[static_cast<std::size_t>(number)].seen, view) ? 1 : 0;
        if (seen_lines < 2) continue;
        throw NotationError("view " + std::to_string(view + 1) + " sees two lines of " +
                            point_name(point) + ", so it sees the point: write 'P' there");
    }
}

} // namespace

void refuse_too_many(const Problem& problem) {
    if (problem.points.size() > most_points || problem.lines.size() > most_lines)
        throw NotationError("a problem has at most 100 points and 100 lines: leave some out");
}

void refuse_invalid(const Problem& problem) {
    refuse_too_many(problem);
    for (std::size_t i = 0; i < problem.lines.size(); ++i)
        for (std::size_t j = i + 1; j < problem.lines.size(); ++j)
            refuse_common_points(problem.lines[i], problem.lines[j]);
    for (const Line& line : problem.lines)
        refuse_unseen_line(problem, line);
    for (int point = 0; point < static_cast<int>(problem.points.size()); ++point)
        refuse_unseen_point(problem, point);
    if (!in_order_of_construction(problem))
        throw NotationError("the points cannot be chosen one after the other, each on at most one "
                            "line through two earlier points: leave out a point that the others "
                            "determine");
}

} // namespace plprove
