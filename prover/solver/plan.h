// How a problem is solved: which camera equations it leads to, and which of its images go there.
//
// In three views the problem is reduced (Theorems 2 and 7 of the paper) and its dangling pins are
// fixed (Theorem 6). What remains is a problem of the 27 features, of some label class. In two
// views it is the five-point problem.
#pragma once

#include "prover/problem/notation.h"
#include "prover/solver/observation.h"
#include "prover/three_views/camera_system.h"

#include <array>
#include <optional>

namespace plprove {

/// Where the images of a feature of the reduced problem come from.
struct SourceFeature {
    std::size_t feature = 0; ///< of the problem
    std::vector<int> pins;   ///< for each line of the reduced feature a line of the problem's
};

struct SolvePlan {
    Features problem;
    /// In three views the number of the label class; nothing in two.
    std::optional<std::size_t> number;
    /// View v of the class is view view_of[v] of the problem, counted from 0.
    std::array<int, 3> view_of{0, 1, 2};
    /// One for each feature of the class, in its order; in two views the five points.
    std::vector<SourceFeature> sources;

    int views() const { return problem.front().views(); }
};

/// Throws BadInput where the problem is neither minimal nor camera-minimal: it says why.
SolvePlan plan(const Features& problem);

/// In two views: the directions of the five points, in each of the views.
std::array<std::array<Eigen::Vector3d, 5>, 2> five_points(const SolvePlan& plan,
                                                          const Observation& observation);

/// In three views: the images for the camera equations of the class: a unit vector for each free
/// vector of `system`. What the class sees and the problem does not is a line through a seen point;
/// the cameras do not depend on which, so any is taken.
std::vector<Eigen::Vector3d> class_images(const SolvePlan& plan, const CameraSystem& system,
                                          const Observation& observation);

} // namespace plprove
