#include "prover/reasons/directions.h"

#include "prover/reasons/joined_points.h"

#include <algorithm>
#include <bit>

namespace plprove {

/// Whether the core is a part of the part, and each point of the part on a line of it is in it.
static bool is_core(const Problem& problem, const Subproblem& part, const Subproblem& core) {
    const auto has = [](const std::vector<int>& all, const std::vector<int>& some) {
        return std::ranges::includes(all, some);
    };
    const bool whole_lines = std::ranges::all_of(core.lines, [&](int number) {
        const Line& line = problem.lines[static_cast<std::size_t>(number)];
        return std::ranges::all_of(line.points, [&](int point) {
            return is_in(core.points, point) || !is_in(part.points, point);
        });
    });
    return (core.views & ~part.views) == 0 && std::popcount(core.views) >= 2 &&
           has(part.points, core.points) && has(part.lines, core.lines) && whole_lines &&
           is_part(problem, core);
}

/// How many of these points a view sees.
static int count_seen(const Problem& problem, const std::vector<int>& points, int view) {
    return static_cast<int>(std::ranges::count_if(points, [&](int point) {
        return contains(problem.points[static_cast<std::size_t>(point)], view);
    }));
}

/// What a view without a translation says of directions in the core: of its lines, and of joins
/// between points that no line joins.
static int directions_of_core(const Problem& problem, const Subproblem& core, int view) {
    int lines = 0, unjoined = count_seen(problem, core.points, view);
    for (const int number : core.lines) {
        const Line& line = problem.lines[static_cast<std::size_t>(number)];
        if (contains(line.seen, view)) ++lines;
        std::vector<int> points = line.points;
        std::erase_if(points, [&](int point) { return !is_in(core.points, point); });
        unjoined -= std::max(0, count_seen(problem, points, view) - 1);
    }
    return lines + std::max(0, unjoined - 1);
}

/// Joins the points of each of these lines that are in the part; false if that closes a circle.
static bool join_along(JoinedPoints& joined, const Problem& problem, const Subproblem& part,
                       const std::vector<int>& lines) {
    for (const int number : lines) {
        std::vector<int> points = problem.lines[static_cast<std::size_t>(number)].points;
        std::erase_if(points, [&](int point) { return !is_in(part.points, point); });
        for (std::size_t i = 1; i < points.size(); ++i)
            if (!joined.join(points[0], points[i])) return false;
    }
    return true;
}

/// Whether lines and joins close no circle: those of the core, and all others, the core taken for
/// one point.
static bool is_forest(const Problem& problem, const Subproblem& part, const CameraMotion& motion) {
    const Subproblem& core = motion.core;
    JoinedPoints joined(problem.points.size());
    if (!join_along(joined, problem, part, core.lines)) return false;
    for (const int point : core.points)
        joined.join(point, core.points.front());
    std::vector<int> others;
    std::ranges::set_difference(part.lines, core.lines, std::back_inserter(others));
    return join_along(joined, problem, part, others) &&
           std::ranges::all_of(motion.joins,
                               [&](const auto& join) { return joined.join(join[0], join[1]); });
}

std::optional<int> excess_of_directions(const Problem& problem, const Subproblem& part,
                                        const CameraMotion& motion) {
    const Problem alone = problem_of(problem, part);
    if (alone.cameras->all_matrices) return std::nullopt;
    if (!is_forest(problem, part, motion)) return std::nullopt;
    const Subproblem& core = motion.core;
    if (core.views != 0 && !is_core(problem, part, core)) return std::nullopt;
    int result = 3 * alone.views - 4 - alone.cameras->dimension(alone.views);
    for (const int number : part.lines)
        if (!is_in(core.lines, number))
            result +=
                conditions_in(problem.lines[static_cast<std::size_t>(number)].seen & part.views);
    for (const auto& [a, b] : motion.joins)
        result += conditions_in(problem.points[static_cast<std::size_t>(a)] &
                                problem.points[static_cast<std::size_t>(b)] & part.views);
    if (core.views == 0) return result;
    const Problem scene = problem_of(problem, core);
    result += dimension_in_views(scene) - dimension_in_space(scene) - (3 * scene.views - 4);
    for (int view = 0; view < problem.views; ++view)
        if (contains(part.views & ~core.views, view))
            result += directions_of_core(problem, core, view);
    return result;
}

std::optional<int> excess_of_pencils(const Problem& problem, const Subproblem& part,
                                     const CameraMotion& motion) {
    const auto seen = [&](int point) {
        return problem.points[static_cast<std::size_t>(point)] & part.views;
    };
    if (!problem.cameras->all_matrices || seen(motion.centre) != part.views) return std::nullopt;
    int result = 8 - 5 * std::popcount(part.views);
    for (const int number : part.lines) {
        const Line& line = problem.lines[static_cast<std::size_t>(number)];
        std::vector<int> points = line.points;
        std::erase_if(points, [&](int point) { return !is_in(part.points, point); });
        if (contains(line, motion.centre)) {
            if (points.size() > 1) return std::nullopt;
            result += conditions_in(line.seen & part.views);
            continue;
        }
        const auto shared = std::ranges::count_if(
            points, [&](int point) { return std::popcount(seen(point)) >= 2; });
        result += std::max(0, static_cast<int>(shared) - 2);
    }
    for (const int point : part.points)
        if (point != motion.centre) result += conditions_in(seen(point));
    return result;
}

} // namespace plprove
