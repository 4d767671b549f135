// Problems that contain a smaller minimal problem: their solutions come in blocks, one for each
// solution of the smaller one, which monodromy moves as a whole. Images that move only the rest of
// the problem do not exchange blocks, so neither do they show that blocks are missing.
#pragma once

#include "prover/degree/images.h"

#include <span>

namespace plprove {

struct Subproblems {
    /// The pairs of views, counted from 0, that share exactly five points: the five-point problem.
    std::vector<std::array<int, 2>> five_points;
    /// Whether the pencil equations alone determine the rotations.
    bool rotations = false;
    /// Whether the trace test moves images of each of these smaller problems.
    bool tested = true;
};

Subproblems subproblems(const CameraSystem& system);

/// Whether the law of the five-point problem holds: for generic images it leaves 20 relative poses
/// of the two cameras (D. Nister, PAMI 2004), each with equally many solutions.
bool has_all_poses(const Subproblems& subproblems, const CameraChart& chart,
                   std::span<const CameraPoint> solutions);

} // namespace plprove
