#include "prover/reasons/find_camera_motion.h"

#include "prover/reasons/find_central_motion.h"
#include "prover/reasons/reason.h"
#include "prover/reasons/smaller_parts.h"

#include <bit>
#include <vector>

namespace plprove {

namespace {

/// Each camera alone; the part loses points and lines that would keep it at its place.
void consider_cameras(ReasonSearch& search, const Problem& problem, const Subproblem& part) {
    for (int view = 0; view < problem.views; ++view) {
        if (!contains(part.views, view)) continue;
        const CameraMotion motion{.kind = MotionKind::camera, .moving = ViewSet{1} << view};
        search.consider(densest(problem, part, motion), motion);
    }
}

/// Motions of some cameras of the part; where it has many views, of one.
void consider_motions_of_some(ReasonSearch& search, const Subproblem& part) {
    constexpr int many_views = 9; // 3^8 choices of a part and of what moves are a second
    const bool many = std::popcount(part.views) >= many_views;
    for (ViewSet moving = 1; moving < part.views; ++moving)
        if ((moving & ~part.views) == 0 && (!many || std::has_single_bit(moving)))
            search.consider_motions(part, moving);
}

/// Motions of all cameras of these views; the part loses the points that they do not keep. Of
/// projective cameras all planes and points through some points and lines are tried.
void consider_motions_of_less(ReasonSearch& search, const Problem& problem,
                              const Subproblem& part) {
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

} // namespace

void consider_camera_motions(ReasonSearch& search, const Problem& problem, const Subproblem& part) {
    consider_cameras(search, problem, part);
    consider_motions_of_some(search, part);
    consider_motions_of_less(search, problem, part);
}

void consider_planes(ReasonSearch& search, const Problem& problem, const Subproblem& part) {
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

} // namespace plprove
