#include "prover/solver/sample_solver.h"

#include "prover/solver/alignment.h"
#include "prover/solver/five_points.h"
#include "prover/solver/poses.h"
#include "prover/solver/reconstruction.h"

#include <algorithm>
#include <limits>

namespace plprove {

namespace {

/// In a random chart, in which real cameras are not at infinity.
ChartedEquations charted(const CameraSystem& system) {
    Random random(0, 0);
    CameraChart chart{{random.complex3(), random.complex3()}, {}};
    for (Complex& x : chart.centre)
        x = random.complex();
    return {system, chart, random_constants(system, random)};
}

} // namespace

SampleSolver::SampleSolver(const Features& problem, std::size_t paths)
    : plan_(plprove::plan(problem)), paths_(paths) {
    if (!plan_.number) return;
    const Signature& signature = label_classes()[*plan_.number];
    equations_ = charted(camera_system(signature));
    extension_ = ExtensionSolver::make(signature);
    if (!extension_) paths_from_.emplace(equations_->system);
}

std::vector<std::vector<Pose<double>>> SampleSolver::solve(const SeenImages& images) const {
    std::vector<std::vector<Pose<double>>> result;
    const auto points = std::ranges::count_if(plan_.problem, &Feature::has_point);
    for (const std::vector<ComplexPose>& found :
         plan_.number ? of_three_views(images.observation) : of_two_views(images.observation)) {
        if (!are_real(found)) continue;
        const Solution solution = real_solution(images, real_poses(found));
        if (solution.in_front == points && explains(solution, images))
            result.push_back(real_poses(solution.cameras));
    }
    return result;
}

std::vector<std::vector<ComplexPose>>
SampleSolver::of_three_views(const Observation& observation) const {
    const auto images = class_images(plan_, equations_->system, observation);
    std::vector<std::vector<ComplexPose>> result;
    for (const QuaternionCameras& cameras : extension_ ? registered(images) : at_ends(images))
        result.push_back(in_problem_order(poses_of(cameras), plan_.view_of));
    return result;
}

std::vector<QuaternionCameras>
SampleSolver::at_ends(const std::vector<Eigen::Vector3d>& images) const {
    std::vector<QuaternionCameras> result;
    for (const auto& end : paths_from_->follow(images, paths_))
        if (end) result.push_back(*end);
    return result;
}

std::vector<QuaternionCameras>
SampleSolver::registered(const std::vector<Eigen::Vector3d>& images) const {
    constexpr int most = std::numeric_limits<int>::max();
    ZerosAtRest zeros(*equations_, complex_images(images), most, 1);
    zeros.add(extension_->cameras(equations_->system, images, 0, 1,
                                  ExtensionSolver::Wanted::real_in_front));
    std::vector<QuaternionCameras> result;
    for (const CameraPoint& zero : zeros.found().points())
        result.push_back(equations_->chart.cameras(zero));
    return result;
}

std::vector<std::vector<ComplexPose>>
SampleSolver::of_two_views(const Observation& observation) const {
    const auto [first, second] = five_points(plan_, observation);
    std::vector<std::vector<ComplexPose>> result;
    for (const ComplexPose& pose : five_point_poses(first, second))
        fix_scale(result.emplace_back(std::vector<ComplexPose>{{}, pose}));
    return result;
}

} // namespace plprove
