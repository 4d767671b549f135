// Poses from matches of which some are wrong: RANSAC with local optimisation around the solvers of
// minimal problems (O. Chum, J. Matas, J. Kittler, DAGM 2003), scored as MSAC (P. Torr, A.
// Zisserman, CVIU 2000).
#pragma once

#include "prover/estimator/refinement.h"
#include "prover/problem/feature.h"
#include "prover/solver/sample_solver.h"

#include <cstdint>

namespace plprove {

struct EstimateOptions {
    double threshold = 2;     ///< pixels: what is farther off is wrong
    double confidence = 0.99; ///< that a sample without wrong matches is among those drawn
    int least_samples = 8;
    int most_samples = 1000;
    std::uint64_t seed = 0;
    unsigned threads = 1; ///< the estimate does not depend on it
    bool covariance = false;
};

struct Estimate {
    Poses cameras;
    Inliers inliers;
    int samples = 0;
    double rms = 0;             ///< pixels, of the inliers
    Eigen::MatrixXd covariance; ///< as Refined has it
};

/// The cameras that explain most, by samples of the problem that the solver solves. Nothing where
/// no sample led to cameras that explain more than it.
std::optional<Estimate> estimate(const Matches& matches, const SampleSolver& solver,
                                 const EstimateOptions& options);

} // namespace plprove
