// Zeros of the camera equations that are known to the last digits of a double, told apart.
#pragma once

#include "prover/degree/camera_system.h"

#include <map>
#include <optional>

namespace plprove {

/// Different zeros for the same images. Unlike a SolutionSet it tells zeros apart that are very
/// near each other, as those with nearly isotropic rotations are where fields of view are narrow.
class ZeroSet {
public:
    static constexpr double same = 1e-11; ///< relative distance of approximations of one zero

    std::optional<std::size_t> find(const CameraPoint& zero) const;
    /// Adds what is not there yet. Returns whether it was not.
    bool add(const CameraPoint& zero);
    const std::vector<CameraPoint>& zeros() const { return zeros_; }
    int size() const { return static_cast<int>(zeros_.size()); }

private:
    std::vector<CameraPoint> zeros_;
    std::multimap<double, std::size_t> by_key_;
};

} // namespace plprove
