#include "prover/problem/problem.h"

#include <algorithm>

namespace plprove {

namespace {

/// Of `points`, how many are less than `bound`.
int count_below(const std::vector<int>& points, int bound) {
    return static_cast<int>(std::ranges::count_if(points, [&](int x) { return x < bound; }));
}

/// A point that may be constructed last of those not `done`: at most one of its lines has two
/// others of them. The last such point, so that a valid order stays as it is.
std::optional<int> last_point(const Problem& problem, const std::vector<bool>& done) {
    for (int point = static_cast<int>(problem.points.size()) - 1; point >= 0; --point) {
        if (done[static_cast<std::size_t>(point)]) continue;
        int carriers = 0;
        for (const int number : lines_through(problem, point)) {
            const std::vector<int>& on_line =
                problem.lines[static_cast<std::size_t>(number)].points;
            const auto left = std::ranges::count_if(
                on_line, [&](int x) { return !done[static_cast<std::size_t>(x)]; });
            carriers += left >= 3 ? 1 : 0;
        }
        if (carriers <= 1) return point;
    }
    return std::nullopt;
}

/// The problem whose point i is point order[i] of `problem`.
Problem reordered(const Problem& problem, const std::vector<int>& order) {
    Problem result = problem;
    std::vector<int> place(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
        result.points[i] = problem.points[static_cast<std::size_t>(order[i])];
    }
    for (Line& line : result.lines) {
        for (int& point : line.points)
            point = place[static_cast<std::size_t>(point)];
        std::ranges::sort(line.points);
    }
    return result;
}

} // namespace

bool contains(const Line& line, int point) {
    return std::ranges::binary_search(line.points, point);
}

std::vector<int> lines_through(const Problem& problem, int point) {
    std::vector<int> numbers;
    for (std::size_t i = 0; i < problem.lines.size(); ++i)
        if (contains(problem.lines[i], point)) numbers.push_back(static_cast<int>(i));
    return numbers;
}

std::vector<int> seen_points(const Problem& problem, const Line& line, int view) {
    std::vector<int> points;
    for (const int point : line.points)
        if (contains(problem.points[static_cast<std::size_t>(point)], view))
            points.push_back(point);
    return points;
}

std::optional<int> carrier(const Problem& problem, int point) {
    for (const int number : lines_through(problem, point))
        if (count_below(problem.lines[static_cast<std::size_t>(number)].points, point) >= 2)
            return number;
    return std::nullopt;
}

int own_points(const Line& line) {
    return 2 - std::min(2, static_cast<int>(line.points.size()));
}

bool is_constructible_in_order(const Problem& problem) {
    for (int point = 0; point < static_cast<int>(problem.points.size()); ++point) {
        int carriers = 0;
        for (const int number : lines_through(problem, point)) {
            const Line& line = problem.lines[static_cast<std::size_t>(number)];
            carriers += count_below(line.points, point) >= 2 ? 1 : 0;
        }
        if (carriers > 1) return false;
    }
    return true;
}

std::optional<Problem> in_order_of_construction(const Problem& problem) {
    std::vector<bool> done(problem.points.size(), false);
    std::vector<int> order;
    while (order.size() < problem.points.size()) {
        const std::optional<int> last = last_point(problem, done);
        if (!last) return std::nullopt;
        done[static_cast<std::size_t>(*last)] = true;
        order.push_back(*last);
    }
    std::ranges::reverse(order);
    return reordered(problem, order);
}

int dimension_in_space(const Problem& problem) {
    int dimension = 0;
    for (int point = 0; point < static_cast<int>(problem.points.size()); ++point)
        dimension += carrier(problem, point) ? 1 : 3;
    for (const Line& line : problem.lines)
        dimension += 2 * own_points(line);
    return dimension;
}

int dimension_in_view(const Problem& problem, int view) {
    int dimension = 0;
    for (const ViewSet seen : problem.points)
        dimension += contains(seen, view) ? 2 : 0;
    for (const Line& line : problem.lines) {
        if (!contains(line.seen, view)) continue;
        // With three seen points or more, each beyond the second loses one parameter.
        dimension += 2 - static_cast<int>(seen_points(problem, line, view).size());
    }
    return dimension;
}

int dimension_in_views(const Problem& problem) {
    int dimension = 0;
    for (int view = 0; view < problem.views; ++view)
        dimension += dimension_in_view(problem, view);
    return dimension;
}

int dimension_of_cameras(CameraModel model, int views) {
    return model == CameraModel::calibrated ? 6 * views - 7 : 11 * views - 15;
}

bool is_balanced(const Problem& problem) {
    return dimension_in_space(problem) + dimension_of_cameras(problem.model, problem.views) ==
           dimension_in_views(problem);
}

} // namespace plprove
