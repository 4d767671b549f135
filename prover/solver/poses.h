// From the unknowns of the camera equations to cameras.
#pragma once

#include "prover/solver/solution.h"
#include "prover/three_views/camera_system.h"

namespace plprove {

/// The three cameras: camera 1 is [I | 0], the distance of the centres of cameras 1 and 2 is 1 (in
/// the Hermitian norm, where they are complex). The scale has the sign, or the phase, that makes
/// the largest coordinate of the second centre positive.
std::vector<ComplexPose> poses_of(const QuaternionCameras& cameras);

/// The other way: quaternions and centres in the frame of camera 1, in any unit of length.
QuaternionCameras quaternion_cameras(const std::vector<ComplexPose>& poses);

/// A quaternion whose matrix is a multiple of the rotation (certs/FORMAT.md, section 2).
std::array<Complex, 4> quaternion(const Eigen::Matrix3cd& R);

/// Whether the cameras are real, up to rounding.
bool are_real(const std::vector<ComplexPose>& poses);

/// The real cameras next to them, with exact rotations.
std::vector<Pose<double>> real_poses(const std::vector<ComplexPose>& poses);

std::vector<ComplexPose> complex_poses(const std::vector<Pose<double>>& poses);

/// The same cameras as camera view_of[v] of the problem sees them for v = 0, 1, 2: in the frame of
/// the problem's camera 1, and in its unit of length.
std::vector<ComplexPose> in_problem_order(const std::vector<ComplexPose>& poses,
                                          const std::array<int, 3>& view_of);

/// Scales the translations so that the distance of the centres of cameras 1 and 2 is 1, as poses_of
/// does.
void fix_scale(std::vector<ComplexPose>& poses);

} // namespace plprove
