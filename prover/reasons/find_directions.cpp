#include "prover/reasons/find_directions.h"

#include "prover/reasons/joined_points.h"
#include "prover/reasons/smaller_parts.h"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace plprove {

namespace {

/// Joins of points that many views see together, as long as they close no circle with each other
/// and the lines, the points of the core taken for one.
std::vector<std::array<int, 2>> best_joins(const Problem& problem, const Subproblem& part,
                                           const Subproblem& core) {
    std::vector<std::pair<int, std::array<int, 2>>> candidates; // by how many views see them
    for (const int a : part.points)
        for (const int b : part.points) {
            const ViewSet both = problem.points[static_cast<std::size_t>(a)] &
                                 problem.points[static_cast<std::size_t>(b)] & part.views;
            if (a < b && std::popcount(both) > 2)
                candidates.push_back({std::popcount(both), {a, b}});
        }
    std::ranges::stable_sort(candidates, std::greater{},
                             [](const auto& candidate) { return candidate.first; });
    JoinedPoints joined(problem.points.size());
    for (const int point : core.points)
        joined.join(point, core.points.front());
    for (const int number : part.lines) {
        const std::vector<int>& points = problem.lines[static_cast<std::size_t>(number)].points;
        for (const int point : points)
            joined.join(points.front(), point);
    }
    std::vector<std::array<int, 2>> joins;
    for (const auto& [views, join] : candidates)
        if (joined.join(join[0], join[1])) joins.push_back(join);
    return joins;
}

/// A count of directions of a part, and of a core.
class Directions {
public:
    Directions(ReasonSearch& search, const Problem& problem, Subproblem part)
        : search_(search), problem_(problem), part_(std::move(part)) {}

    /// Considers no core; then for each choice of views a core. Part and core lose points and lines
    /// as long as the count grows.
    void consider_all() {
        if (!is_part(problem_, part_)) return;
        search_.consider(part_, with({part_, {}}));
        for (ViewSet views = 1; views <= part_.views && !search_.found(); ++views) {
            if ((views & ~part_.views) != 0 || std::popcount(views) < 2) continue;
            Choice choice{part_, seen_in(problem_, part_, views)};
            while (std::optional<Choice> better = better_than(choice))
                choice = *std::move(better);
            search_.consider(choice.part, with(choice));
        }
    }

private:
    struct Choice {
        Subproblem part, core;
    };

    CameraMotion with(const Choice& choice) const {
        return {.kind = MotionKind::directions,
                .joins = best_joins(problem_, choice.part, choice.core),
                .core = choice.core};
    }

    std::optional<int> count(const Choice& choice) const {
        if (!is_part(problem_, choice.part)) return std::nullopt;
        return excess(problem_, choice.part, with(choice));
    }

    /// A choice without some point and its pins, or without a line, that counts more: the core
    /// lacks it, or the part, too.
    std::optional<Choice> better_than(const Choice& choice) const {
        std::vector<Choice> candidates;
        for (const int point : choice.core.points)
            candidates.push_back({choice.part, without_point(problem_, choice.core, point)});
        for (const int line : choice.core.lines)
            candidates.push_back({choice.part, without_line(choice.core, line)});
        for (const int point : choice.part.points)
            candidates.push_back({without_point(problem_, choice.part, point),
                                  without_point(problem_, choice.core, point)});
        for (const int line : choice.part.lines)
            candidates.push_back(
                {without_line(choice.part, line), without_line(choice.core, line)});
        const std::optional<int> before = count(choice);
        for (Choice& candidate : candidates)
            if (count(candidate) > before) return std::move(candidate);
        return std::nullopt;
    }

    ReasonSearch& search_;
    const Problem& problem_;
    Subproblem part_;
};

} // namespace

void consider_directions(ReasonSearch& search, const Problem& problem, ViewSet views) {
    Subproblem all = whole(problem);
    all.views = views;
    Subproblem simple = all;
    std::erase_if(simple.lines, [&](int number) {
        return problem.lines[static_cast<std::size_t>(number)].points.size() > 1;
    });
    Subproblem lines_alone = simple;
    lines_alone.points.clear();
    for (const Subproblem& part : {simple, lines_alone, all})
        Directions(search, problem, part).consider_all();
}

void consider_pencils(ReasonSearch& search, const Problem& problem, ViewSet views) {
    for (int centre = 0; centre < static_cast<int>(problem.points.size()); ++centre) {
        if ((problem.points[static_cast<std::size_t>(centre)] & views) != views) continue;
        Subproblem part{views, {}, lines_through(problem, centre)};
        for (int point = 0; point < static_cast<int>(problem.points.size()); ++point)
            if (point == centre || std::ranges::none_of(part.lines, [&](int line) {
                    return contains(problem.lines[static_cast<std::size_t>(line)], point);
                }))
                part.points.push_back(point);
        for (int line = 0; line < static_cast<int>(problem.lines.size()); ++line)
            if (!is_in(part.lines, line) &&
                std::ranges::count_if(problem.lines[static_cast<std::size_t>(line)].points,
                                      [&](int p) { return is_in(part.points, p); }) > 2)
                part.lines.push_back(line);
        std::ranges::sort(part.lines);
        if (is_part(problem, part))
            search.consider(part, {.kind = MotionKind::pencils, .centre = centre});
    }
}

} // namespace plprove
