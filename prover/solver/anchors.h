// The true cameras of a scene by a few paths: fast, and most of the time. Who wants all solutions
// takes camera_solver.h.
//
// Paths start at anchors, scenes whose cameras are known, as in P. Hruby, T. Duff, A. Leykin, T.
// Pajdla (CVPR 2022). Their paths are real, and most of these end where two solutions meet. Here
// both ends have real images, and those on the way are (1 - t) x + t (1 + i) y: a quarter of a
// circle beside the real way. So nearly all paths arrive, and far more of them at the true cameras
// than if each solution were as likely: for Chicago, which has 312, one of twelve.
#pragma once

#include "prover/three_views/images.h"

#include <Eigen/Core>
#include <optional>

namespace plprove {

/// A scene in front of three cameras that are not turned: the first is at the origin, the second at
/// (1, 0, 0).
struct Anchor {
    std::vector<Eigen::Vector3d> images; ///< one unit vector for each free vector of the system
    Eigen::Vector3d third;               ///< the centre of camera 3
    std::vector<Complex3> constants;     ///< of the auxiliary lines and points
};

/// A random scene, the same for the same number. The middle is 3 to 10 times as far from the first
/// camera as the second is.
Anchor random_anchor(const CameraSystem& system, std::uint64_t number);

class AnchoredSolver {
public:
    explicit AnchoredSolver(const CameraSystem& system);

    /// Where as many paths lead, from the anchors nearest to the images: real images, one unit
    /// vector for each free vector of the system. To six digits at least; nothing for a path that
    /// is lost. May be called by several threads at once.
    std::vector<std::optional<QuaternionCameras>> follow(const std::vector<Eigen::Vector3d>& images,
                                                         std::size_t paths) const;

private:
    using Turns = std::array<Eigen::Matrix3d, 3>; ///< of each view: a rotation

    /// Images turned, view by view, towards those of an anchor.
    struct Turned {
        Turns turn;
        std::vector<Eigen::Vector3d> images;
    };

    Turned towards(const std::vector<Eigen::Vector3d>& target,
                   const std::vector<Eigen::Vector3d>& images) const;
    /// The sum of the scalar products; a line is the same with the other sign.
    double similarity(const std::vector<Eigen::Vector3d>& some,
                      const std::vector<Eigen::Vector3d>& others) const;
    std::vector<std::size_t> most_similar(const std::vector<Eigen::Vector3d>& images,
                                          std::size_t count) const;
    TrackedImages way(const Anchor& anchor, const std::vector<Eigen::Vector3d>& to) const;

    CameraSystem system_;
    TrackedSystem tracked_;
    std::vector<Anchor> anchors_;
    /// The images of each anchor, turned towards those of the first.
    std::vector<std::vector<Eigen::Vector3d>> alike_;
};

} // namespace plprove
