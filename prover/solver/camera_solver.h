// All solutions for the cameras, for given images of a label class: by parameter homotopy. Paths
// lead from the solutions of a start to those of the given images.
#pragma once

#include "prover/degree/path_follower.h"
#include "prover/solver/start.h"

#include <Eigen/Core>

namespace plprove {

/// What came of following all paths to some images.
struct FoundCameras {
    std::vector<QuaternionCameras> cameras; ///< different ones
    /// How many solutions the start has more than were found: paths were lost, or end at degenerate
    /// cameras, as some do where images are special, or at rotations with entries beyond 10^12,
    /// which doubles do not hold.
    int lost = 0;
    std::uint64_t steps = 0; ///< of the paths
};

/// Whether to follow lost paths again, with more digits, and all paths on other ways while some
/// are lost.
enum class Effort { once, thorough };

class CameraSolver {
public:
    explicit CameraSolver(Start start);

    /// The solutions for real images, one vector of length 1 for each free vector of system(), to
    /// 13 digits. May be called by several threads at once. The same result for
    /// the same images.
    FoundCameras solve(const std::vector<Eigen::Vector3d>& images, Effort effort) const;

    const CameraSystem& system() const { return system_; }
    const Start& start() const { return start_; }

private:
    class Search;

    Start start_;
    CameraSystem system_;
    TrackedSystem tracked_;
};

} // namespace plprove
