// Poses that fit many matches best: bundle adjustment of points and lines, by Ceres.
#pragma once

#include "prover/estimator/structure.h"

#include <Eigen/Core>

namespace plprove {

/// Which matches count, by their indices, ascending.
struct Inliers {
    std::vector<std::size_t> points, lines;
};

struct RefinementOptions {
    /// Distances beyond this, in pixels, count less and less (Cauchy's loss).
    double scale = 1;
    int iterations = 50; ///< of Levenberg and Marquardt, at most
    bool covariance = false;
};

struct Refined {
    Poses cameras; ///< camera 1 is [I | 0], the translation of camera 2 has length 1
    /// Of the cameras after the first, six entries each: the rotation vector w of exp(w) R, in
    /// radians, and t. Empty if it was not asked for, or the matches do not fix the cameras.
    Eigen::MatrixXd covariance;
    double rms = 0; ///< of all distances that were to be small, in pixels
};

/// The cameras near the given ones that minimise distances in the images: of seen points from those
/// of points in space, of the ends of segments from the images of lines. A line through a point
/// that counts stays a line through it. Nothing where the matches are too few to fix the cameras.
std::optional<Refined> refined(const Poses& cameras, const Matches& matches, const Inliers& inliers,
                               const RefinementOptions& options);

} // namespace plprove
