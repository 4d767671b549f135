// A solution: cameras, and what they say of the features in space.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <vector>

namespace plprove {

/// A camera takes the point X of space to R X + t, whose direction is the image point.
template <class Scalar>
struct Pose {
    Eigen::Matrix<Scalar, 3, 3> R = Eigen::Matrix<Scalar, 3, 3>::Identity();
    Eigen::Matrix<Scalar, 3, 1> t = Eigen::Matrix<Scalar, 3, 1>::Zero();
};

using ComplexPose = Pose<std::complex<double>>;

/// A line in space: a point of it and a direction of length 1.
struct SpaceLine {
    Eigen::Vector3cd point;
    Eigen::Vector3cd direction;
};

/// A feature in space. What the cameras and images leave open is missing.
struct SpaceFeature {
    std::optional<Eigen::Vector3cd> point;
    std::vector<std::optional<SpaceLine>> lines; ///< one for each line of the feature
    /// For each view that sees the point whether the point is in front of that camera; nothing for
    /// other views, and where the solution is not real.
    std::vector<std::optional<bool>> in_front;
};

/// Camera 1 is [I | 0]. The unit of length is the distance of the centres of cameras 1 and 2.
struct Solution {
    bool real = false;
    std::vector<ComplexPose> cameras;
    std::vector<SpaceFeature> features;
    /// The largest distance, in pixels of the view, of an image of a feature from what was to be
    /// seen.
    double residual = 0;
    /// How many points are in front of every camera that sees them.
    int in_front = 0;
    /// For a real solution: by how much the cameras (radians; directions and ratio of the two
    /// translations) change at most, relative to a small change of the images (radians). Infinite
    /// where the cameras are not isolated.
    std::optional<double> condition;
};

} // namespace plprove
