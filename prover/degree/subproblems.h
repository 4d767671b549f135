// Problems that contain a smaller minimal problem: their solutions come in blocks, one for each
// solution of the smaller one, which monodromy moves as a whole. Images that move only the rest of
// the problem do not exchange blocks, so neither do they show that blocks are missing.
#pragma once

#include "prover/degree/degree.h"
#include "prover/degree/images.h"

#include <span>

namespace plprove {

/// How many relative poses of two cameras five generic points that both see leave (D. Nister, PAMI
/// 2004): two for each of 10 essential matrices.
inline constexpr int poses_of_five_points = 20;

struct Subproblems {
    /// The pairs of views, counted from 0, that share exactly five points: the five-point problem.
    std::vector<std::array<int, 2>> five_points;
    /// Whether the pencil equations alone determine the rotations.
    bool rotations = false;
    /// Whether the trace test moves images of each of these smaller problems.
    bool tested = true;
};

Subproblems subproblems(const CameraSystem& system);

/// Whether the law of the five-point problem holds: for generic images it leaves so many relative
/// poses of the two cameras, each with equally many solutions.
bool has_all_poses(const Subproblems& subproblems, const CameraChart& chart,
                   std::span<const CameraPoint> solutions);

/// The different relative poses of a pair of views among the solutions, and the different essential
/// matrices of these.
PoseCount count_poses(const std::array<int, 2>& pair, const CameraChart& chart,
                      std::span<const CameraPoint> solutions);

} // namespace plprove
