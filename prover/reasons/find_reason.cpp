#include "prover/reasons/find_central_motion.h"
#include "prover/reasons/joined_points.h"
#include "prover/reasons/reason.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <iterator>

namespace plprove {

namespace {

std::optional<FourCollinear> four_collinear(const Problem& problem) {
    for (const Line& line : problem.lines)
        for (int first = 0; first < problem.views; ++first)
            for (int second = first + 1; second < problem.views; ++second) {
                const ViewSet both = ViewSet{1} << first | ViewSet{1} << second;
                std::vector<int> seen;
                for (const int point : line.points)
                    if ((problem.points[static_cast<std::size_t>(point)] & both) == both)
                        seen.push_back(point);
                if (seen.size() >= 4)
                    return FourCollinear{{seen[0], seen[1], seen[2], seen[3]}, {first, second}};
            }
    return std::nullopt;
}

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

/// All numbers that are in one of two ascending lists.
std::vector<int> united(const std::vector<int>& a, const std::vector<int>& b) {
    std::vector<int> result;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
}

/// The best reason seen so far.
class Search {
public:
    explicit Search(const Problem& problem) : problem_(problem) {}

    void consider(const Subproblem& part, const CameraMotion& motion) {
        const std::optional<int> found = excess(problem_, part, motion);
        if (!found || *found < 1 || (best_ && best_->excess >= *found)) return;
        best_ = OverconstrainedPart{part, motion, *found};
    }

    /// Motions with these points among the generators, and up to `more` lines.
    void consider_with_lines(const Subproblem& part, CameraMotion& motion, std::size_t first,
                             int more) {
        consider(part, motion);
        if (more == 0) return;
        for (std::size_t i = first; i < part.lines.size(); ++i) {
            motion.lines.push_back(part.lines[i]);
            consider_with_lines(part, motion, i + 1, more - 1);
            motion.lines.pop_back();
        }
    }

    void consider_motions(const Subproblem& part, ViewSet moving) {
        const CameraModel& cameras = *problem_.cameras;
        // Lines among the generators are worth a search only where all cameras move: there are
        // up to 4,096 choices of moving views.
        const int most_lines = moving == part.views ? 2 : 0;
        CameraMotion plane{.kind = MotionKind::plane, .moving = moving};
        if (cameras.all_matrices) plane.points = seen_by(part, moving);
        consider_with_lines(part, plane, 0, cameras.all_matrices ? most_lines : 0);
        for (const int centre : part.points) {
            CameraMotion about = star(centre, moving);
            if (cameras.all_matrices) about.points = seen_by(part, moving);
            std::erase(about.points, centre);
            consider_with_lines(part, about, 0, cameras.all_matrices ? most_lines : 0);
        }
    }

    bool found() const { return best_.has_value(); }

    /// Each point with some of the lines through it, and each line with some of its points. Then as
    /// many of these together as have parameters, lines alone first.
    void consider_loose(const Subproblem& part) {
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

    std::optional<OverconstrainedPart> take() { return std::move(best_); }

private:
    std::vector<int> seen_by(const Subproblem& part, ViewSet views) const {
        std::vector<int> points;
        for (const int point : part.points)
            if ((problem_.points[static_cast<std::size_t>(point)] & views) != 0)
                points.push_back(point);
        return points;
    }

    const Problem& problem_;
    std::optional<OverconstrainedPart> best_;
};

/// The part of a problem that two views or more see in common: of each point and line, it has those
/// that all these views see.
Subproblem common_part(const Problem& problem, ViewSet views) {
    Subproblem part{views, {}, {}};
    for (std::size_t i = 0; i < problem.points.size(); ++i)
        if ((problem.points[i] & views) == views) part.points.push_back(static_cast<int>(i));
    for (std::size_t i = 0; i < problem.lines.size(); ++i)
        if ((problem.lines[i].seen & views) == views) part.lines.push_back(static_cast<int>(i));
    return part;
}

/// The part without the point and its pins, or without the line.
Subproblem without_point(const Problem& problem, Subproblem part, int point) {
    std::erase(part.points, point);
    std::erase_if(part.lines, [&](int number) {
        return problem.lines[static_cast<std::size_t>(number)].points == std::vector<int>{point};
    });
    return part;
}

Subproblem without_line(Subproblem part, int line) {
    std::erase(part.lines, line);
    return part;
}

/// Leaves out points and lines as long as the images of the rest, which the motion keeps, have more
/// parameters to spare.
Subproblem densest(const Problem& problem, Subproblem part, const CameraMotion& motion = {}) {
    const auto parameters_to_spare = [&](const Subproblem& candidate) {
        return is_part(problem, candidate) ? excess(problem, candidate, motion) : std::nullopt;
    };
    for (bool changed = true; changed;) {
        changed = false;
        std::vector<Subproblem> candidates;
        for (const int point : part.points)
            candidates.push_back(without_point(problem, part, point));
        for (const int line : part.lines)
            candidates.push_back(without_line(part, line));
        for (const int point : part.points) {
            candidates.push_back(part);
            std::erase(candidates.back().points, point);
        }
        for (const Subproblem& candidate : candidates)
            if (!changed && parameters_to_spare(candidate) > parameters_to_spare(part)) {
                part = candidate;
                changed = true;
            }
    }
    return part;
}

/// Each camera alone; the part loses points and lines that would keep it at its place.
void consider_cameras(Search& search, const Problem& problem, const Subproblem& part) {
    for (int view = 0; view < problem.views; ++view) {
        if (!contains(part.views, view)) continue;
        const CameraMotion motion{.kind = MotionKind::camera, .moving = ViewSet{1} << view};
        search.consider(densest(problem, part, motion), motion);
    }
}

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

/// The part of it that its views see.
Subproblem seen_in(const Problem& problem, Subproblem part, ViewSet views) {
    part.views = views;
    std::erase_if(part.lines, [&](int number) {
        return (problem.lines[static_cast<std::size_t>(number)].seen & views) == 0;
    });
    std::erase_if(part.points, [&](int point) {
        return (problem.points[static_cast<std::size_t>(point)] & views) == 0 &&
               std::ranges::none_of(part.lines, [&](int line) {
                   return contains(problem.lines[static_cast<std::size_t>(line)], point);
               });
    });
    return part;
}

/// A count of directions of a part, and of a core.
class Directions {
public:
    Directions(Search& search, const Problem& problem, Subproblem part)
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

    Search& search_;
    const Problem& problem_;
    Subproblem part_;
};

/// The lines through each point that all these views see, its joins with all others that are on
/// none of these lines, and lines of three of these or more.
void consider_pencils(Search& search, const Problem& problem, ViewSet views) {
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

/// The lines with one point at most: with all points, or without any. Then all lines, without
/// points that close circles.
void consider_directions(Search& search, const Problem& problem, ViewSet views) {
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

/// Motions of some cameras of the part; where it has many views, of one.
void consider_motions_of_some(Search& search, const Subproblem& part) {
    constexpr int many_views = 9; // 3^8 choices of a part and of what moves are a second
    const bool many = std::popcount(part.views) >= many_views;
    for (ViewSet moving = 1; moving < part.views; ++moving)
        if ((moving & ~part.views) == 0 && (!many || std::has_single_bit(moving)))
            search.consider_motions(part, moving);
}

/// Motions of all cameras of these views; the part loses the points that they do not keep. Of
/// projective cameras all planes and points through some points and lines are tried.
void consider_motions_of_less(Search& search, const Problem& problem, const Subproblem& part) {
    std::vector<CameraMotion> motions{{.kind = MotionKind::plane, .moving = part.views}};
    for (const int centre : part.points)
        motions.push_back(star(centre, part.views));
    constexpr int most_generators = 3;
    for (std::size_t i = 0; i < motions.size(); ++i) { // grows
        const CameraMotion motion = motions[i];
        const Subproblem kept = kept_part(problem, part, motion);
        if (is_part(problem, kept)) search.consider(kept, motion);
        const std::size_t generators = motion.points.size() + motion.lines.size();
        if (!problem.cameras->all_matrices || generators == most_generators) continue;
        for (const int point : part.points) {
            if (!motion.lines.empty() || (!motion.points.empty() && point <= motion.points.back()))
                continue;
            motions.push_back(motion);
            motions.back().points.push_back(point);
        }
        for (const int line : part.lines) {
            if (!motion.lines.empty() && line <= motion.lines.back()) continue;
            motions.push_back(motion);
            motions.back().lines.push_back(line);
        }
    }
}

/// Motions of one camera, of some, and of all; the part may lose what they do not keep.
void consider_camera_motions(Search& search, const Problem& problem, const Subproblem& part) {
    consider_cameras(search, problem, part);
    consider_motions_of_some(search, part);
    consider_motions_of_less(search, problem, part);
}

void consider_central_motions(Search& search, const Problem& problem, const Subproblem& part) {
    if (const std::optional<CameraMotion> central = find_central_motion(problem, part))
        search.consider(part, *central);
}

/// Motions of the cameras that see nothing of the part but points in a plane, whatever plane
/// through some points and lines; of all these cameras or some.
void consider_planes(Search& search, const Problem& problem, const Subproblem& part) {
    for (CameraMotion motion : generators_of(problem, part, MotionKind::plane)) {
        motion.moving = part.views;
        const Subproblem kept = kept_part(problem, part, motion);
        ViewSet free = part.views;
        for (const int point : part.points)
            if (!is_in(kept.points, point))
                free &= ~problem.points[static_cast<std::size_t>(point)];
        for (ViewSet moving = free; moving > 0; moving = (moving - 1) & free) {
            motion.moving = moving;
            search.consider(part, motion);
        }
    }
}

/// The motions of just this part.
std::optional<OverconstrainedPart> motion_of(const Problem& problem, const Subproblem& part) {
    Search search(problem);
    search.consider(part, {});
    search.consider_loose(part);
    consider_camera_motions(search, problem, part);
    consider_planes(search, problem, part);
    if (!search.found()) consider_central_motions(search, problem, part);
    if (search.found()) return search.take();
    if (const std::optional<CameraMotion> central = find_any_central_motion(problem, part))
        search.consider(part, *central);
    return search.take();
}

std::optional<OverconstrainedPart> overconstrained_part(const Problem& problem) {
    Search search(problem);
    const ViewSet all = all_views(problem.views);
    search.consider(whole(problem), {});
    search.consider_motions(whole(problem), all);
    search.consider_loose(whole(problem));
    if (std::optional<OverconstrainedPart> found = search.take()) return found;
    for (ViewSet views = 1; views <= all; ++views) {
        if (views != all) search.consider_motions(whole(problem), views);
        if (std::popcount(views) < 2) continue;
        Subproblem in_these_views = whole(problem);
        in_these_views.views = views;
        for (const Subproblem& part :
             {common_part(problem, views), densest(problem, std::move(in_these_views))}) {
            if (!is_part(problem, part)) continue;
            search.consider(part, {});
            search.consider_motions(part, views);
        }
    }
    if (std::optional<OverconstrainedPart> found = search.take()) return found;
    for (ViewSet views = all; views > 0 && !search.found(); --views) {
        if (std::popcount(views) < 2) continue;
        Subproblem part = whole(problem);
        part.views = views;
        search.consider_loose(part);
        search.consider_loose(densest(problem, part));
        consider_camera_motions(search, problem, part);
        // The generators of projective cameras make many choices: small parts of many views are
        // left out.
        constexpr int most_left_out = 3;
        if (!problem.cameras->all_matrices || problem.views - std::popcount(views) <= most_left_out)
            consider_central_motions(search, problem, part);
        consider_directions(search, problem, views);
        consider_pencils(search, problem, views);
    }
    return search.take();
}

} // namespace

/// What the search finds: of the problem, or of its cameras taken as projective ones.
template <class Find>
static std::optional<Reason> also_projective(const Problem& problem, const Find& find) {
    if (std::optional<OverconstrainedPart> found = find(problem)) return *std::move(found);
    if (problem.cameras->all_matrices) return std::nullopt;
    Problem projective = problem;
    projective.cameras = &projective_cameras;
    std::optional<OverconstrainedPart> found = find(projective);
    if (!found) return std::nullopt;
    found->motion.projective = true;
    return *std::move(found);
}

std::optional<Reason> find_reason(const Problem& problem) {
    if (const std::optional<FourCollinear> four = four_collinear(problem)) return *four;
    return also_projective(problem, overconstrained_part);
}

std::optional<Reason> find_reason_in(const Problem& problem, const Subproblem& part) {
    return also_projective(problem,
                           [&](const Problem& cameras) { return motion_of(cameras, part); });
}

} // namespace plprove
