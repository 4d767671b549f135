#include "prover/solver/solve.h"

#include "prover/catalogue/degrees.h"
#include "prover/solver/condition.h"
#include "prover/solver/five_points.h"
#include "prover/solver/poses.h"
#include "prover/system/exit.h"

#include <algorithm>
#include <tuple>

namespace plprove {

std::string_view name(Completeness completeness) {
    switch (completeness) {
    case Completeness::certified:
        return "certified";
    case Completeness::evidence:
        return "evidence";
    case Completeness::unknown:
        return "unknown";
    }
    return {};
}

namespace {

/// Whether the degree of the class, which is certified on file, is this one.
bool degree_is_certified(std::size_t number, int degree) {
    const Signature& signature = label_classes()[number];
    const std::size_t constraint =
        class_number(label_classes(), constraint_representative(signature));
    return degree_on_file(constraint) == degree;
}

/// Real solutions before others, and those with more points in front of the cameras before those
/// with fewer; then by the second camera, so that equal images have answers in the same order.
void sort(std::vector<Solution>& solutions) {
    const auto key = [](const Solution& solution) {
        const Eigen::Matrix3cd& R = solution.cameras[1].R;
        return std::tuple(!solution.real, -solution.in_front, R(0, 0).real(), R(0, 0).imag(),
                          R(0, 1).real(), R(0, 1).imag());
    };
    std::ranges::stable_sort(solutions, {}, key);
}

/// Drops what rounding errors have made of images of extreme size: it explains nothing.
void drop_what_explains_nothing(Answer& answer, const SeenImages& images) {
    const auto dropped = std::erase_if(
        answer.solutions, [&](const Solution& solution) { return !explains(solution, images); });
    if (dropped == 0) return;
    answer.found -= static_cast<int>(dropped);
    answer.lost += static_cast<int>(dropped);
    answer.complete = Completeness::unknown;
}

} // namespace

void finish(Answer& answer, const SeenImages& images) {
    drop_what_explains_nothing(answer, images);
    sort(answer.solutions);
}

Solver::Solver(SolvePlan plan, Start start) : plan_(std::move(plan)) {
    if (!plan_.number) throw BadInput("problems in two views need no start");
    if (*plan_.number != start.number)
        throw BadInput("the start is of class " + std::to_string(start.number) +
                       ", and the problem of class " + std::to_string(*plan_.number) +
                       ": make one with `plprove start " + std::to_string(*plan_.number) + "`");
    certified_degree_ = degree_is_certified(start.number, start.degree());
    cameras_.emplace(std::move(start));
}

Solver::Solver(SolvePlan plan) : plan_(std::move(plan)) {
    if (plan_.number)
        throw BadInput("problems in three views need a start: make one with `plprove start " +
                       std::to_string(*plan_.number) + "`");
}

Answer Solver::solve(const SeenImages& images, const SolveOptions& options) const {
    if (!plan_.number) return solve_two_views(images, options);
    return solve(images, class_images(plan_, cameras_->system(), images.observation), options);
}

Answer Solver::solve(const SeenImages& images, const std::vector<Eigen::Vector3d>& class_images,
                     const SolveOptions& options) const {
    const FoundCameras found = cameras_->solve(class_images, options.search);
    Answer answer;
    answer.degree = degree();
    answer.found = static_cast<int>(found.cameras.size());
    answer.lost = found.lost;
    if (found.lost == 0 && certified_degree_) answer.complete = Completeness::certified;
    for (const QuaternionCameras& cameras : found.cameras) {
        const std::vector<ComplexPose> poses = poses_of(cameras);
        answer.zeros.push_back(standard_chart().point(cameras));
        const std::vector<ComplexPose> ordered = in_problem_order(poses, plan_.view_of);
        if (are_real(poses)) {
            Solution& solution =
                answer.solutions.emplace_back(real_solution(images, real_poses(ordered)));
            if (options.conditions)
                solution.condition = condition(cameras_->system(), class_images, real_poses(poses));
        } else if (options.complex) {
            answer.solutions.push_back(complex_solution(images, ordered));
        }
    }
    finish(answer, images);
    return answer;
}

Answer Solver::solve_two_views(const SeenImages& images, const SolveOptions& options) const {
    const auto [first, second] = five_points(plan_, images.observation);
    Answer answer;
    for (const ComplexPose& pose : five_point_poses(first, second)) {
        ++answer.found;
        std::vector<ComplexPose> poses{{}, pose};
        fix_scale(poses);
        if (are_real(poses)) {
            const auto real = real_poses(poses);
            Solution& solution = answer.solutions.emplace_back(real_solution(images, real));
            if (options.conditions)
                solution.condition = condition({first.begin(), first.end()},
                                               {second.begin(), second.end()}, real[1]);
        } else if (options.complex) {
            answer.solutions.push_back(complex_solution(images, poses));
        }
    }
    answer.degree = degree();
    answer.lost = answer.degree - answer.found;
    if (answer.lost == 0) answer.complete = Completeness::certified;
    finish(answer, images);
    return answer;
}

Solver make_solver(const Features& problem) {
    SolvePlan how = plan(problem);
    if (!how.number) return Solver(std::move(how));
    const std::size_t number = *how.number;
    return {std::move(how), cached_start(number)};
}

} // namespace plprove
