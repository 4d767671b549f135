// Solutions that are known only approximately, told apart and found again.
#pragma once

#include "prover/degree/camera_system.h"

#include <map>
#include <optional>
#include <vector>

namespace plprove {

/// Whether these are approximations of one solution, up to SolutionSet::same.
bool approximates(const CameraPoint& point, const CameraPoint& other);

/// Different solutions for the same images, which can be found again from a numerical
/// approximation.
class SolutionSet {
public:
    static constexpr double same = 1e-6; ///< relative distance of approximations of one solution

    std::optional<int> find(const CameraPoint& point) const;
    int add(const CameraPoint& point);
    int size() const { return static_cast<int>(points_.size()); }
    const CameraPoint& operator[](int index) const {
        return points_[static_cast<std::size_t>(index)];
    }
    const std::vector<CameraPoint>& points() const { return points_; }

private:
    std::vector<CameraPoint> points_;
    std::multimap<double, int> by_key_;
};

} // namespace plprove
