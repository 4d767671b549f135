// Solutions that are known only approximately, told apart and found again.
#pragma once

#include "prover/degree/camera_system.h"

#include <map>
#include <optional>
#include <vector>

namespace plprove {

/// The relative distance of approximations of one solution, where paths end.
inline constexpr double near_at_path_ends = 1e-6;

/// Whether these are approximations of one solution, up to this relative distance.
bool approximates(const CameraPoint& point, const CameraPoint& other,
                  double near = near_at_path_ends);

/// Different solutions for the same images, which can be found again from a numerical
/// approximation.
class SolutionSet {
public:
    /// `near` is the relative distance of approximations of one solution.
    explicit SolutionSet(double near = near_at_path_ends) : near_(near) {}

    std::optional<int> find(const CameraPoint& point) const;
    int add(const CameraPoint& point);
    int size() const { return static_cast<int>(points_.size()); }
    const CameraPoint& operator[](int index) const {
        return points_[static_cast<std::size_t>(index)];
    }
    const std::vector<CameraPoint>& points() const { return points_; }

private:
    double near_;
    std::vector<CameraPoint> points_;
    std::multimap<double, int> by_key_;
};

} // namespace plprove
