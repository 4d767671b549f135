// How much the cameras of a solution depend on the images.
#pragma once

#include "prover/solver/solution.h"
#include "prover/three_views/camera_system.h"

namespace plprove {

/// By how much the cameras change at most, relative to a small change of the images (Solution).
/// `images` are unit vectors, one for each free vector of the system, `poses` the three cameras
/// that solve it. From derivatives by central differences, so to few digits.
double condition(const CameraSystem& system, const std::vector<Eigen::Vector3d>& images,
                 const std::vector<Pose<double>>& poses);

/// The same for the five-point problem: `first` and `second` are what the two views see.
double condition(const std::vector<Eigen::Vector3d>& first,
                 const std::vector<Eigen::Vector3d>& second, const Pose<double>& pose);

} // namespace plprove
