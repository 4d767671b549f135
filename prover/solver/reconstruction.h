// The scene behind given cameras: features in space, and how well their images fit.
#pragma once

#include "prover/solver/observation.h"
#include "prover/solver/solution.h"

namespace plprove {

/// The images and what takes normalised coordinates to pixels.
struct SeenImages {
    Observation observation;
    std::vector<Eigen::Matrix3d> calibration; ///< one upper triangular matrix for each view
};

/// Features, residual and counts for real cameras. The scale gets the sign that puts more points in
/// front of the cameras that see them.
Solution real_solution(const SeenImages& images, std::vector<Pose<double>> poses);

/// Whether it shows the images to a hundredth of their size: solutions show them to 10^-13, seldom
/// to 10^-5, and what rounding errors make of images of extreme size, or of degenerate zeros, shows
/// something else.
bool explains(const Solution& solution, const SeenImages& images);

/// real_solution, for cameras that are not real, for which nothing is in front.
Solution complex_solution(const SeenImages& images, const std::vector<ComplexPose>& poses);

} // namespace plprove
