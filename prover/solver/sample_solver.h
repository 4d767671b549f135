// Real cameras for samples of matches, many of them: fast, and the true ones most of the time.
#pragma once

#include "prover/solver/anchors.h"
#include "prover/solver/extension.h"
#include "prover/solver/images.h"
#include "prover/solver/plan.h"
#include "prover/solver/solution.h"
#include "prover/solver/zeros_at_rest.h"

namespace plprove {

class SampleSolver {
public:
    /// How many paths a sample takes, where paths are followed: more of them cost as much more, and
    /// add less and less.
    static constexpr std::size_t usual_paths = 16;

    /// Throws BadInput where the problem cannot be solved (plan.h).
    explicit SampleSolver(const Features& problem, std::size_t paths = usual_paths);

    const Features& problem() const { return plan_.problem; }
    /// Of how many samples without noise and wrong matches the true cameras are found: a share,
    /// about, of the usual number of paths.
    double success() const { return paths_from_ ? 0.7 : 1; }

    /// Real cameras that see these images, with all points in front of them: all there are in two
    /// views and of extensions of the five-point problem, else some, the true ones of most scenes
    /// among them. Camera 1 is [I | 0], the distance of cameras 1 and 2 is 1. Assumes that the
    /// images have what the problem says that the views see. May be called by several threads at
    /// once. The same for the same images.
    std::vector<std::vector<Pose<double>>> solve(const SeenImages& images) const;

private:
    /// Cameras that may be complex.
    std::vector<std::vector<ComplexPose>> of_two_views(const Observation& observation) const;
    std::vector<std::vector<ComplexPose>> of_three_views(const Observation& observation) const;
    std::vector<QuaternionCameras> registered(const std::vector<Eigen::Vector3d>& images) const;
    std::vector<QuaternionCameras> at_ends(const std::vector<Eigen::Vector3d>& images) const;

    SolvePlan plan_;
    std::size_t paths_;
    // In three views:
    std::optional<ChartedEquations> equations_;
    std::optional<ExtensionSolver> extension_;
    std::optional<AnchoredSolver> paths_from_; ///< if it is no extension of the five-point problem
};

} // namespace plprove
