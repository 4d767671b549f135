#include "prover/reasons/reason_search.h"

#include <algorithm>

namespace plprove {

namespace {

/// The subsets of some numbers; of many, those of the first ten.
std::vector<std::vector<int>> subsets(const std::vector<int>& numbers) {
    constexpr std::size_t most = 10;
    const std::size_t count = std::min(numbers.size(), most);
    std::vector<std::vector<int>> all(std::size_t{1} << count);
    for (std::size_t chosen = 0; chosen < all.size(); ++chosen)
        for (std::size_t i = 0; i < count; ++i)
            if ((chosen >> i & 1) != 0) all[chosen].push_back(numbers[i]);
    return all;
}

/// The points of a part that some of these views see.
std::vector<int> seen_by(const Problem& problem, const Subproblem& part, ViewSet views) {
    std::vector<int> points;
    for (const int point : part.points)
        if ((problem.points[static_cast<std::size_t>(point)] & views) != 0) points.push_back(point);
    return points;
}

} // namespace

void ReasonSearch::consider(const Subproblem& part, const CameraMotion& motion) {
    const std::optional<int> found = excess(problem_, part, motion);
    if (!found || *found < 1 || (best_ && best_->excess >= *found)) return;
    best_ = OverconstrainedPart{part, motion, *found};
}

void ReasonSearch::consider_with_lines(const Subproblem& part, CameraMotion& motion,
                                       std::size_t first, int more) {
    consider(part, motion);
    if (more == 0) return;
    for (std::size_t i = first; i < part.lines.size(); ++i) {
        motion.lines.push_back(part.lines[i]);
        consider_with_lines(part, motion, i + 1, more - 1);
        motion.lines.pop_back();
    }
}

void ReasonSearch::consider_motions(const Subproblem& part, ViewSet moving) {
    const bool generators = problem_.cameras->all_matrices;
    // Lines among the generators are worth a search only where all cameras move: there are up to
    // 4,096 choices of moving views.
    const int most_generators = generators && moving == part.views ? 2 : 0;
    CameraMotion plane{.kind = MotionKind::plane, .moving = moving};
    if (generators) plane.points = seen_by(problem_, part, moving);
    consider_with_lines(part, plane, 0, most_generators);
    for (const int centre : part.points) {
        CameraMotion about = star(centre, moving);
        if (generators) about.points = seen_by(problem_, part, moving);
        std::erase(about.points, centre);
        consider_with_lines(part, about, 0, most_generators);
    }
}

std::vector<CameraMotion> ReasonSearch::single_loose(const Subproblem& part) const {
    std::vector<CameraMotion> single;
    for (const int point : part.points)
        for (std::vector<int>& lines : subsets(lines_through(problem_, point)))
            single.push_back(
                {.kind = MotionKind::loose, .points = {point}, .lines = std::move(lines)});
    for (const int line : part.lines)
        for (std::vector<int>& points :
             subsets(problem_.lines[static_cast<std::size_t>(line)].points))
            single.push_back(
                {.kind = MotionKind::loose, .points = std::move(points), .lines = {line}});
    return single;
}

void ReasonSearch::consider_loose(const Subproblem& part) {
    std::vector<CameraMotion> single = single_loose(part);
    for (const CameraMotion& motion : single)
        consider(part, motion);
    std::ranges::stable_sort(single, {},
                             [](const CameraMotion& motion) { return motion.points.size(); });
    CameraMotion all{.kind = MotionKind::loose};
    for (const CameraMotion& motion : single) {
        CameraMotion more = all;
        more.points = united(all.points, motion.points);
        more.lines = united(all.lines, motion.lines);
        if (motions(problem_, part, more) > motions(problem_, part, all)) all = more;
    }
    consider(part, all);
}

} // namespace plprove
