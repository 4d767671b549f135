#include "prover/solver/poses.h"

#include "prover/solver/rotation.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace plprove {

namespace {

Eigen::Vector3cd centre(const ComplexPose& pose) {
    return -pose.R.transpose() * pose.t;
}

/// The same cameras in the frame of the first one: X = R_1^T (Y - t_1).
std::vector<ComplexPose> in_first_frame(std::vector<ComplexPose> poses) {
    const ComplexPose first = poses[0];
    for (ComplexPose& pose : poses) {
        pose.R = (pose.R * first.R.transpose()).eval();
        pose.t = (pose.t - pose.R * first.t).eval();
    }
    poses[0] = {};
    return poses;
}

} // namespace

void fix_scale(std::vector<ComplexPose>& poses) {
    const Eigen::Vector3cd second = centre(poses[1]);
    Eigen::Index largest = 0;
    second.cwiseAbs().maxCoeff(&largest);
    const Complex phase = second[largest] / std::abs(second[largest]);
    for (ComplexPose& pose : poses)
        pose.t /= second.norm() * phase;
}

std::vector<ComplexPose> poses_of(const QuaternionCameras& cameras) {
    std::vector<ComplexPose> poses(3);
    for (std::size_t v = 0; v < 2; ++v) {
        const Complex3& c = cameras.centre[v];
        poses[v + 1].R = rotation_of_quaternion(cameras.quaternion[v]);
        poses[v + 1].t = -poses[v + 1].R * Eigen::Vector3cd(c[0], c[1], c[2]);
    }
    fix_scale(poses);
    return poses;
}

QuaternionCameras quaternion_cameras(const std::vector<ComplexPose>& poses) {
    const std::vector<ComplexPose> framed = in_first_frame(poses);
    QuaternionCameras result;
    for (std::size_t v = 0; v < 2; ++v) {
        result.quaternion[v] = quaternion(framed[v + 1].R);
        const Eigen::Vector3cd c = centre(framed[v + 1]);
        result.centre[v] = {c[0], c[1], c[2]};
    }
    return result;
}

// A column of the products of its coordinates, the largest one.
std::array<Complex, 4> quaternion(const Eigen::Matrix3cd& R) {
    Eigen::Matrix4cd products;
    products << 1.0 + R.trace(), R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1), //
        0, 1.0 + R(0, 0) - R(1, 1) - R(2, 2), R(0, 1) + R(1, 0), R(0, 2) + R(2, 0),       //
        0, 0, 1.0 - R(0, 0) + R(1, 1) - R(2, 2), R(1, 2) + R(2, 1),                       //
        0, 0, 0, 1.0 - R(0, 0) - R(1, 1) + R(2, 2);
    products.triangularView<Eigen::StrictlyLower>() = products.transpose();
    Eigen::Index largest = 0;
    products.diagonal().cwiseAbs().maxCoeff(&largest);
    const Eigen::Vector4cd q = products.col(largest).normalized();
    return {q[0], q[1], q[2], q[3]};
}

bool are_real(const std::vector<ComplexPose>& poses) {
    constexpr double rounding = 1e-7;
    double imaginary = 0, size = 1;
    for (const ComplexPose& pose : poses) {
        imaginary = std::max(
            {imaginary, pose.R.imag().cwiseAbs().maxCoeff(), pose.t.imag().cwiseAbs().maxCoeff()});
        size = std::max({size, pose.R.cwiseAbs().maxCoeff(), pose.t.cwiseAbs().maxCoeff()});
    }
    return imaginary < rounding * size;
}

std::vector<Pose<double>> real_poses(const std::vector<ComplexPose>& poses) {
    std::vector<Pose<double>> result;
    for (const ComplexPose& pose : poses) {
        const Eigen::Matrix3d near = pose.R.real();
        const Eigen::Quaterniond quaternion(near);
        result.push_back({quaternion.normalized().toRotationMatrix(), pose.t.real()});
    }
    return result;
}

std::vector<ComplexPose> complex_poses(const std::vector<Pose<double>>& poses) {
    std::vector<ComplexPose> result;
    for (const Pose<double>& pose : poses)
        result.push_back({pose.R.cast<Complex>(), pose.t.cast<Complex>()});
    return result;
}

std::vector<ComplexPose> in_problem_order(const std::vector<ComplexPose>& poses,
                                          const std::array<int, 3>& view_of) {
    std::vector<ComplexPose> ordered(poses.size());
    for (std::size_t v = 0; v < poses.size(); ++v)
        ordered[static_cast<std::size_t>(view_of[v])] = poses[v];
    ordered = in_first_frame(std::move(ordered));
    fix_scale(ordered);
    return ordered;
}

} // namespace plprove
