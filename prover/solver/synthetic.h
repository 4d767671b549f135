// Synthetic scenes: cameras that look at points and lines, and what they see.
#pragma once

#include "prover/solver/images.h"

#include <cstdint>
#include <string>

namespace plprove {

struct SyntheticScene {
    Features problem;
    std::optional<Problem> general; ///< see ImagedProblem
    /// Camera 1 is [I | 0], the centres of cameras 1 and 2 have the distance 1.
    std::vector<Pose<double>> cameras;
    std::vector<Eigen::Vector3d> points;                  ///< of a free line one of its points
    std::vector<std::vector<Eigen::Vector3d>> directions; ///< of the lines of each feature
    SeenImages images;
};

/// A random scene of the problem in front of the cameras, which look at it from different sides,
/// with focal lengths of 800 pixels and images of 640x480. The same scene for the same seed.
SyntheticScene synthetic_scene(const ImagedProblem& problem, std::uint64_t seed);

/// Its images as a JSON file for `plprove solve`, to a millionth of a pixel. Lines are given by two
/// points; the first is the point that the line passes through, if the view sees it.
std::string images_file(const SyntheticScene& scene);

} // namespace plprove
