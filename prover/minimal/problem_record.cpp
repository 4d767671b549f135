#include "prover/minimal/problem_record.h"

#include "prover/minimal/dependent_part.h"
#include "prover/minimal/random_instance.h"
#include "prover/problem/notation.h"
#include "prover/system/words.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace plprove {

namespace {

constexpr int tries = 100;
constexpr std::int64_t small = 9;

Residue minor_at(const Problem& problem, const Instance& instance) {
    return nmod_mat_det(jacobian_modulo_q(problem, instance).get());
}

/// A point with small coordinates and full rank. Large coordinates tell whether there is one.
std::optional<Minor> find_full_rank(const Problem& problem) {
    if (minor_at(problem, random_instance(problem, 1, most_coordinate)) == 0) return std::nullopt;
    for (unsigned seed = 1; seed <= tries; ++seed) {
        Minor found{.instance = random_instance(problem, seed, small)};
        found.value = minor_at(problem, found.instance);
        if (found.value != 0) return found;
    }
    return std::nullopt;
}

struct Explain {
    const Problem& problem;

    std::string operator()(const Minor&) const {
        return "the images put one condition for each parameter of cameras and scene, "
               "independent at generic images";
    }
    std::string operator()(const Unbalanced&) const {
        const int parameters =
            dimension_in_space(problem) + problem.cameras->dimension(problem.views);
        const int images = dimension_in_views(problem);
        return "cameras and scene have " + counted(parameters, "parameter") + ", the images " +
               std::to_string(images);
    }
    std::string operator()(const FourCollinear& four) const {
        return "points " + std::to_string(four.points[0] + 1) + ", " +
               std::to_string(four.points[1] + 1) + ", " + std::to_string(four.points[2] + 1) +
               " and " + std::to_string(four.points[3] + 1) +
               " lie on a line: their cross-ratio is the same in views " +
               std::to_string(four.views[0] + 1) + " and " + std::to_string(four.views[1] + 1);
    }
    std::string operator()(const OverconstrainedPart& reason) const {
        const std::string conditions =
            ", so its images satisfy at least " + counted(reason.excess, "condition");
        return subject(reason.part) + ' ' + what_happens(reason.motion) + conditions;
    }

    std::string subject(const Subproblem& part) const {
        const Subproblem all = whole(problem);
        if (part.views == all.views && part.points == all.points && part.lines == all.lines)
            return "the problem";
        std::vector<int> views;
        for (int view = 0; view < problem.views; ++view)
            if (contains(part.views, view)) views.push_back(view);
        return "the part of points" + numbers_from_one(part.points) + " and lines" +
               numbers_from_one(part.lines) + " in views" + numbers_from_one(views);
    }

    std::string what_happens(const CameraMotion& motion) const {
        if (motion.projective) return "before projective cameras " + kept_by(motion, true);
        if (motion.kind == MotionKind::directions)
            return "has fewer directions of lines, and rotations and calibrations of cameras, than "
                   "its images say";
        return kept_by(motion, problem.cameras->all_matrices);
    }

    static std::string kept_by(const CameraMotion& motion, bool all_matrices) {
        if (motion.kind == MotionKind::none) return "has fewer parameters than its images";
        if (motion.kind == MotionKind::loose)
            return "looks the same when " +
                   (motion.points.empty()  ? "lines" + numbers_from_one(motion.lines)
                    : motion.lines.empty() ? "points" + numbers_from_one(motion.points)
                                           : "points" + numbers_from_one(motion.points) +
                                                 " and lines" + numbers_from_one(motion.lines)) +
                   " move";
        if (motion.kind == MotionKind::camera)
            return "looks the same when camera " +
                   std::to_string(std::countr_zero(motion.moving) + 1) + " moves";
        if (motion.kind == MotionKind::pencils)
            return "has fewer lines through point " + std::to_string(motion.centre + 1) +
                   ", and maps of these to pencils, than its images say";
        if (motion.kind == MotionKind::plane)
            return all_matrices ? "looks the same when cameras move and keep the images of a plane"
                                : "looks the same when cameras move and do not turn";
        const std::optional<int> centre = point_of_star(motion);
        if (!centre && motion.elements.front().kind == CentralElement::Centre::axis)
            return "looks the same when some cameras turn about line " +
                   std::to_string(motion.elements.front().centre + 1) + ", with what they see";
        if (!centre)
            return "looks the same when some cameras slide towards centres, with what they see";
        const std::string point = " point " + std::to_string(*centre + 1);
        return !all_matrices
                   ? "looks the same when cameras slide along their rays to" + point
                   : "looks the same when cameras move and keep the images of all lines through" +
                         point;
    }
};

} // namespace

bool is_minimal(const ProblemRecord& certificate) {
    return std::holds_alternative<Minor>(certificate.claim);
}

std::string verdict(const ProblemRecord& certificate) {
    if (is_minimal(certificate)) return "minimal";
    return std::holds_alternative<Unbalanced>(certificate.claim) ? "unbalanced" : "not minimal";
}

std::string explanation(const ProblemRecord& certificate) {
    return std::visit(Explain{certificate.problem}, certificate.claim);
}

/// A reason why the problem is not minimal: of any part; then of small ones that ranks show.
static std::optional<Reason> reason_against(const Problem& problem) {
    std::optional<Reason> reason = find_reason(problem);
    if (reason) return reason;
    for (const Subproblem& part : dependent_parts(problem))
        if ((reason = find_reason_in(problem, part))) return reason;
    return std::nullopt;
}

std::variant<ProblemRecord, Undecided> try_to_certify(const Problem& problem) {
    ProblemRecord certificate{parse_problem(notation(problem)), Unbalanced{}};
    if (!is_balanced(certificate.problem)) return certificate;
    if (std::optional<Minor> full_rank = find_full_rank(certificate.problem))
        certificate.claim = *std::move(full_rank);
    else if (const std::optional<Reason> reason = reason_against(certificate.problem))
        std::visit([&](const auto& found) { certificate.claim = found; }, *reason);
    else
        return look_at(certificate.problem);
    return certificate;
}

ProblemRecord certify(const Problem& problem) {
    auto found = try_to_certify(problem);
    if (const auto* open = std::get_if<Undecided>(&found))
        throw std::runtime_error("no certificate found for " + notation(open->problem) +
                                 ", which is conjectured not minimal: " + explanation(*open) +
                                 ". Please report it");
    return std::get<ProblemRecord>(std::move(found));
}

} // namespace plprove
