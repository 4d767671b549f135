#include "prover/estimator/structure.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace plprove {

namespace {

/// Sines of smaller squares count as 0. Comparisons are such that what is not a number is refused.
constexpr double parallel = 1e-12;

/// In front of the cameras that see it.
bool in_front(const Eigen::Vector3d& point, const PointMatch& match, const Poses& cameras) {
    for (std::size_t v = 0; v < cameras.size(); ++v)
        if (match[v] && !(cameras[v].R.row(2).dot(point) + cameras[v].t.z() > 0)) return false;
    return true;
}

} // namespace

std::optional<Eigen::Vector3d> space_point(const PointMatch& match, const Poses& cameras) {
    std::vector<double> depth(cameras.size(), 1);
    Eigen::Vector3d point;
    // First all rays count alike; then by depth, which makes it distances in the images.
    for (int round = 0; round < 2; ++round) {
        Eigen::Matrix3d left = Eigen::Matrix3d::Zero();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        for (std::size_t v = 0; v < cameras.size(); ++v) {
            if (!match[v]) continue;
            const auto& [R, t] = cameras[v];
            for (int k = 0; k < 2; ++k) {
                const double x = (*match[v])[k];
                const Eigen::Vector3d a = (R.row(k) - x * R.row(2)).transpose() / depth[v];
                left += a * a.transpose();
                right += a * ((x * t.z() - t[k]) / depth[v]);
            }
        }
        const Eigen::LDLT<Eigen::Matrix3d> solver(left);
        const Eigen::Vector3d pivots = solver.vectorD();
        if (!(pivots.minCoeff() > parallel * pivots.maxCoeff())) return std::nullopt;
        point = solver.solve(right);
        if (!in_front(point, match, cameras)) return std::nullopt;
        for (std::size_t v = 0; v < cameras.size(); ++v)
            depth[v] = cameras[v].R.row(2).dot(point) + cameras[v].t.z();
    }
    return point;
}

std::optional<PluckerLine> space_line(const LineMatch& match, const Poses& cameras) {
    Eigen::Matrix4d gram = Eigen::Matrix4d::Zero();
    for (std::size_t v = 0; v < cameras.size(); ++v) {
        if (!match[v]) continue;
        const Eigen::Vector3d normal =
            match[v]->begin.homogeneous().cross(match[v]->end.homogeneous()).normalized();
        Eigen::Vector4d plane;
        plane << cameras[v].R.transpose() * normal, normal.dot(cameras[v].t);
        gram += plane * plane.transpose();
    }
    // The planes of the pencil of the line: X of it has pi.X = 0 for both.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> pencil(gram);
    if (!(pencil.eigenvalues()[2] > parallel * pencil.eigenvalues()[3])) return std::nullopt;
    const Eigen::Vector4d p = pencil.eigenvectors().col(2), q = pencil.eigenvectors().col(3);
    const Eigen::Vector3d direction = p.head<3>().cross(q.head<3>());
    const double size = direction.norm();
    if (!(size * size > parallel)) return std::nullopt;
    const Eigen::Vector3d moment = q[3] * p.head<3>() - p[3] * q.head<3>();
    return PluckerLine{direction / size, -moment / size};
}

Eigen::Vector3d image_of(const PluckerLine& line, const Pose<double>& camera) {
    const Eigen::Vector3d direction = camera.R * line.direction;
    return camera.R * line.moment + camera.t.cross(direction);
}

double squared_error(const Eigen::Vector3d& point, const PointMatch& match, const Poses& cameras,
                     const std::vector<PinholeIntrinsics>& intrinsics) {
    double largest = 0;
    for (std::size_t v = 0; v < cameras.size(); ++v) {
        if (!match[v]) continue;
        const Eigen::Vector3d image = cameras[v].R * point + cameras[v].t;
        const double dx = intrinsics[v].fx * (image.x() / image.z() - match[v]->x());
        const double dy = intrinsics[v].fy * (image.y() / image.z() - match[v]->y());
        largest = std::max(largest, dx * dx + dy * dy);
    }
    return largest;
}

double squared_error(const PluckerLine& line, const LineMatch& match, const Poses& cameras,
                     const std::vector<PinholeIntrinsics>& intrinsics) {
    double largest = 0;
    for (std::size_t v = 0; v < cameras.size(); ++v) {
        if (!match[v]) continue;
        const Eigen::Vector3d image = image_of(line, cameras[v]);
        const double a = image.x() / intrinsics[v].fx, b = image.y() / intrinsics[v].fy;
        for (const Eigen::Vector2d& end : {match[v]->begin, match[v]->end}) {
            const double distance = image.dot(end.homogeneous());
            largest = std::max(largest, distance * distance / (a * a + b * b));
        }
    }
    return largest;
}

} // namespace plprove
