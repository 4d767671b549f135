// How far the solutions found are from the cameras and the scene that the images were made of.
#pragma once

#include "prover/solver/solve.h"
#include "prover/solver/synthetic.h"

#include <limits>

namespace solver_tests {

/// The largest difference of an entry of the cameras.
inline double distance(const plprove::Solution& solution, const plprove::SyntheticScene& scene) {
    double largest = 0;
    for (std::size_t v = 0; v < scene.cameras.size(); ++v) {
        const plprove::Pose<double>& truth = scene.cameras[v];
        const Eigen::Matrix3cd R = solution.cameras[v].R - truth.R.cast<plprove::Complex>();
        const Eigen::Vector3cd t = solution.cameras[v].t - truth.t.cast<plprove::Complex>();
        largest = std::max({largest, R.cwiseAbs().maxCoeff(), t.cwiseAbs().maxCoeff()});
    }
    return largest;
}

/// The solution that is nearest to the true cameras; there must be one.
inline const plprove::Solution& nearest(const plprove::Answer& answer,
                                        const plprove::SyntheticScene& scene) {
    const plprove::Solution* best = &answer.solutions.at(0);
    for (const plprove::Solution& solution : answer.solutions)
        if (distance(solution, scene) < distance(*best, scene)) best = &solution;
    return *best;
}

} // namespace solver_tests
