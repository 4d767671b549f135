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

/// A view that sees two features at the same point; all three are counted from 0.
struct SamePoint {
    std::size_t view, first, second;
};

/// The first such view.
inline std::optional<SamePoint> same_point(const Observation& observation) {
    const std::size_t views = observation.empty() ? 0 : observation.front().size();
    for (std::size_t v = 0; v < views; ++v)
        for (std::size_t f = 0; f < observation.size(); ++f)
            for (std::size_t g = 0; g < f; ++g) {
                const auto &x = observation[f][v].point, &y = observation[g][v].point;
                if (x && y && *x == *y) return SamePoint{v, g, f};
            }
    return std::nullopt;
}

} // namespace plprove
