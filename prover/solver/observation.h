// What the views see of the features of a problem, in numbers.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace plprove {

/// What one view sees of a feature. Vectors are homogeneous, in normalised coordinates (the camera
/// matrix is the identity), and of any length. A line l through the seen point x has l·x = 0.
struct Sighting {
    std::optional<Eigen::Vector3d> point;
    /// One for each line of the feature, in the order of their letters; nothing if it is not seen.
    std::vector<std::optional<Eigen::Vector3d>> lines;
};

/// What all views see of a feature.
using FeatureSightings = std::vector<Sighting>;

/// What all views see of all features, in the order of the problem.
using Observation = std::vector<FeatureSightings>;

} // namespace plprove
