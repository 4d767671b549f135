#include "checker/family/degree_bound.h"

#include <algorithm>
#include <numeric>

namespace checker {
static bool is_axis(const Line& line) {
    return line.points.size() >= 3;
}

static bool is_on(const Line& line, std::size_t point) {
    return std::ranges::count(line.points, point) > 0;
}

static bool meet(const Line& a, const Line& b) {
    return std::ranges::any_of(a.points, [&](std::size_t point) { return is_on(b, point); });
}

/// Whether two axes share a point: item 1.
static bool axes_meet(const Problem& problem) {
    const auto is_on_two = [&](const Point& point) {
        const auto counts = [&](std::size_t line) { return is_axis(problem.lines[line]); };
        return std::ranges::count_if(point.lines, counts) >= 2;
    };
    return std::ranges::any_of(problem.points, is_on_two);
}

/// The coefficients of the product of 1 + x + ... + x^a over all these a.
static std::vector<std::size_t> product_of_runs(const std::vector<std::size_t>& lengths) {
    std::vector<std::size_t> product{1};
    for (const std::size_t a : lengths) {
        std::vector<std::size_t> longer(product.size() + a);
        for (std::size_t i = 0; i < product.size(); ++i)
            for (std::size_t j = 0; j <= a; ++j)
                longer[i + j] += product[i];
        product = longer;
    }
    return product;
}

/// How many lines of a projective space of dimension n - 1 meet general subspaces, one of
/// codimension a + 1 for each of these a, if these numbers add up to 2 (n - 2). (The coefficients
/// fit: their sum is at most 2^64, as n is at most 34.)
static std::optional<std::size_t> lines_that_meet(const std::vector<std::size_t>& codimensions,
                                                  std::size_t n) {
    if (std::accumulate(codimensions.begin(), codimensions.end(), std::size_t{0}) != 2 * (n - 2))
        return std::nullopt;
    const std::vector<std::size_t> product = product_of_runs(codimensions);
    const std::size_t above = n - 1 < product.size() ? product[n - 1] : 0;
    return product[n - 2] - above;
}

/// From the planes through an axis, if no axes meet: item 2.
static std::optional<std::size_t> bound_of_axis(const Problem& problem, const Line& axis) {
    const std::size_t views = static_cast<std::size_t>(std::popcount(problem.views));
    std::vector<std::size_t> lines_through(problem.points.size()); // that do not meet the axis
    std::vector<std::size_t> codimensions;
    std::size_t n = 3 * views - 2;
    for (const Line& line : problem.lines) {
        if (&line == &axis) continue;
        if (line.points.size() == 2) return std::nullopt;
        if (meet(line, axis)) {
            codimensions.push_back(views - 2);
            continue;
        }
        if (n < views) return std::nullopt;
        n -= views - 2;
        for (const std::size_t point : line.points)
            ++lines_through[point];
    }
    for (std::size_t point = 0; point < problem.points.size(); ++point) {
        if (is_on(axis, point)) continue;
        const std::size_t given = (views - 2) * lines_through[point];
        if (given > 2 * views - 3) return std::nullopt;
        codimensions.push_back(2 * views - 3 - given);
    }
    return lines_that_meet(codimensions, n);
}

/// How many lines there are with at most one point; two points join another one.
static std::size_t directions(const Problem& problem) {
    const auto counts = [](const Line& line) { return line.points.size() <= 1; };
    const auto lines = std::ranges::count_if(problem.lines, counts);
    return static_cast<std::size_t>(lines) + (problem.points.size() >= 2 ? 1 : 0);
}

/// Items 10 and 11: two views, by the axes.
static std::optional<std::size_t> bound_of_fundamental_matrices(const Problem& problem) {
    const bool shared = problem.cameras->name == "shared-focal";
    const auto axes = std::ranges::count_if(problem.lines, is_axis);
    if (axes == 0) return shared ? 30 : 8;
    if (axes == 1) return shared ? 20 : 6;
    if (axes > 2) return std::nullopt;
    if (shared) return axes_meet(problem) ? 10 : 16;
    return 4;
}

/// Items 7 to 9, 12 and 13.
static std::optional<std::size_t> bound_of_upright_shared_focal(const Problem& problem) {
    const int views = std::popcount(problem.views);
    const bool has_axis = std::ranges::any_of(problem.lines, is_axis);
    const auto has_line_of = [&](std::size_t points) {
        return std::ranges::any_of(problem.lines,
                                   [&](const Line& line) { return line.points.size() == points; });
    };
    const bool two_points = problem.points.size() == 2;
    if (views == 2) return has_axis ? 4 : 5;
    if (views == 3 && has_axis) return 6;
    if (views == 3 && directions(problem) >= 3) return 14;
    if (views == 3 && two_points && has_line_of(0)) return 11;
    if (views == 4 && two_points && has_line_of(1)) return 26;
    return std::nullopt;
}

/// Items 4 to 13; none where they do not apply.
static std::optional<std::size_t> bound_of_cameras_in_part(const Problem& problem) {
    const std::string_view cameras = problem.cameras->name;
    const int views = std::popcount(problem.views);
    if (cameras == "focal" && views == 2) {
        Problem uncalibrated = problem;
        uncalibrated.cameras = &projective_cameras;
        const std::optional<std::size_t> bound = degree_bound(uncalibrated);
        return bound ? std::optional(2 * *bound) : std::nullopt;
    }
    if ((cameras == "shared-focal" || cameras == "upright-focal") && views == 2)
        return bound_of_fundamental_matrices(problem);
    if (cameras == "upright" && views == 2) return 4;
    if (cameras == "upright" && views == 3 && directions(problem) >= 2) return 6;
    if (cameras == "upright-shared-focal") return bound_of_upright_shared_focal(problem);
    return std::nullopt;
}

std::optional<std::size_t> degree_bound(const Problem& problem) {
    if (!all_views_see_all(problem)) return std::nullopt;
    if (!problem.cameras->all_matrices) return bound_of_cameras_in_part(problem);
    if (axes_meet(problem)) return 1;
    std::optional<std::size_t> least;
    if (std::popcount(problem.views) == 2) least = 3; // item 3
    for (const Line& line : problem.lines) {
        if (!is_axis(line)) continue;
        const std::optional<std::size_t> bound = bound_of_axis(problem, line);
        if (bound && (!least || *bound < *least)) least = bound;
    }
    return least;
}
} // namespace checker
