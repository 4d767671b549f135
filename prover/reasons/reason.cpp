#include "prover/reasons/reason.h"

#include "prover/reasons/directions.h"

namespace plprove {

std::string numbers_from_one(const std::vector<int>& numbers) {
    std::string text;
    for (const int number : numbers)
        text += ' ' + std::to_string(number + 1);
    return text.empty() ? " -" : text;
}

std::optional<int> excess(const Problem& problem, const Subproblem& part,
                          const CameraMotion& motion) {
    if (motion.projective) {
        if (problem.cameras->all_matrices) return std::nullopt;
        Problem projective = problem;
        projective.cameras = &projective_cameras;
        CameraMotion of_these = motion;
        of_these.projective = false;
        return excess(projective, part, of_these);
    }
    if (motion.kind == MotionKind::directions) return excess_of_directions(problem, part, motion);
    if (motion.kind == MotionKind::pencils) return excess_of_pencils(problem, part, motion);
    const std::optional<int> kept = motions(problem, part, motion);
    if (!kept) return std::nullopt;
    const Problem alone = problem_of(problem, part);
    return dimension_in_views(alone) - dimension_in_space(alone) -
           alone.cameras->dimension(alone.views) + *kept;
}

} // namespace plprove
