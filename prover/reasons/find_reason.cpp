#include "prover/reasons/find_camera_motion.h"
#include "prover/reasons/find_central_motion.h"
#include "prover/reasons/find_directions.h"
#include "prover/reasons/reason.h"
#include "prover/reasons/smaller_parts.h"

#include <bit>

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

void consider_central_motions(ReasonSearch& search, const Problem& problem,
                              const Subproblem& part) {
    if (const std::optional<CameraMotion> central = find_central_motion(problem, part))
        search.consider(part, *central);
}

/// The motions of just this part.
std::optional<OverconstrainedPart> motion_of(const Problem& problem, const Subproblem& part) {
    ReasonSearch search(problem);
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
    ReasonSearch search(problem);
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
