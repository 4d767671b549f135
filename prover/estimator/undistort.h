// Images without the distortion of the lens.
#pragma once

#include <Eigen/Core>

namespace plprove {

/// The model of D. C. Brown, Decentering distortion of lenses (1966), in the form of OpenCV.
struct LensDistortion {
    double k1 = 0, k2 = 0, p1 = 0, p2 = 0, k3 = 0;

    /// Where the lens shows a point; both in normalised coordinates.
    Eigen::Vector2d distorted(const Eigen::Vector2d& x) const {
        const double r2 = x.squaredNorm();
        const double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
        const double twice = 2 * x.x() * x.y();
        return radial * x + Eigen::Vector2d(p1 * twice + p2 * (r2 + 2 * x.x() * x.x()),
                                            p1 * (r2 + 2 * x.y() * x.y()) + p2 * twice);
    }

    /// The point that the lens shows at x. By fixed-point iteration, which converges for lenses
    /// that this model suits.
    Eigen::Vector2d undistorted(const Eigen::Vector2d& x) const {
        constexpr int iterations = 50;
        Eigen::Vector2d result = x;
        for (int i = 0; i < iterations; ++i)
            result += x - distorted(result);
        return result;
    }
};

} // namespace plprove
