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
    /// the last digits of a double. May be called by several threads at once. The same result for
    /// the same images.
    FoundCameras solve(const std::vector<Eigen::Vector3d>& images, Effort effort) const;

    const CameraSystem& system() const { return system_; }
    const Start& start() const { return start_; }

private:
    /// The ends of the straight paths from all solutions of the start, as zeros of `images`, which
    /// are those that the paths lead `to`, but for factors. Two paths rarely have the same end, if
    /// one has jumped.
    PathFollower::Ends follow(PathFollower& follower, const Images& to, const Images& images,
                              Effort effort) const;

    /// The ends as zeros of these images to the last digits; nothing where they lead to none.
    PathFollower::Ends polished(const Images& images, const PathFollower::Ends& ends) const;

    Start start_;
    CameraSystem system_;
    TrackedSystem tracked_;
};

} // namespace plprove
