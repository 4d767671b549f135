#include "prover/solver/consistency.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace plprove {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

/// The unit normal of the line through `point` for which the squared distances of the two points of
/// the line are least.
Vector2d best_normal(const PixelLine& line, const Vector2d& point) {
    if (line.points.empty()) return line.coefficients.head<2>().normalized();
    Matrix2d scatter = Matrix2d::Zero();
    for (const Vector2d& p : line.points)
        scatter += (p - point) * (p - point).transpose();
    return Eigen::SelfAdjointEigenSolver<Matrix2d>(scatter).eigenvectors().col(0);
}

/// What a line with this normal is to pass through.
std::vector<Vector2d> anchors(const PixelLine& line, const Vector2d& point) {
    if (!line.points.empty()) return line.points;
    const double distance =
        line.coefficients.dot(point.homogeneous()) / line.coefficients.head<2>().norm();
    return {point - distance * line.coefficients.head<2>().normalized()};
}

} // namespace

PixelStar nearest_star(const Vector2d& point, const std::vector<PixelLine>& lines) {
    constexpr int most_turns = 200;
    constexpr double rounding = 1e-14;
    Vector2d x = point;
    std::vector<Vector2d> normals(lines.size());
    for (int turn = 0; turn < most_turns; ++turn) {
        Matrix2d matrix = Matrix2d::Identity();
        Vector2d right = point;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            normals[i] = best_normal(lines[i], x);
            const Matrix2d across = normals[i] * normals[i].transpose();
            for (const Vector2d& p : anchors(lines[i], point)) {
                matrix += across;
                right += across * p;
            }
        }
        const Vector2d next = matrix.inverse() * right;
        const bool settled = (next - x).norm() <= rounding * (1 + x.norm());
        x = next;
        if (settled) break;
    }
    PixelStar star{x, {}, (x - point).norm()};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        star.lines.emplace_back(normals[i][0], normals[i][1], -normals[i].dot(x));
        for (const Vector2d& p : anchors(lines[i], point))
            star.moved = std::max(star.moved, std::abs(normals[i].dot(p - x)));
    }
    return star;
}

PixelLine line_through(const Vector2d& p, const Vector2d& q) {
    return {p.homogeneous().cross(q.homogeneous()), {p, q}};
}

namespace {

/// Whether the point is on all lines, up to rounding errors.
bool meet(const Vector2d& point, const std::vector<PixelLine>& lines) {
    constexpr double tolerated = 1e-12;
    return std::ranges::all_of(lines, [&](const PixelLine& line) {
        const Eigen::Vector3d x = point.homogeneous();
        return std::abs(line.coefficients.dot(x)) <=
               tolerated * line.coefficients.norm() * x.norm();
    });
}

} // namespace

Sighting normalised_sighting(const std::optional<Vector2d>& point,
                             const std::vector<std::optional<PixelLine>>& lines,
                             const Eigen::Matrix3d& K, double& moved) {
    Sighting result;
    std::vector<PixelLine> seen;
    for (const auto& line : lines)
        if (line) seen.push_back(*line);
    if (point) {
        Vector2d place = *point;
        if (!meet(place, seen)) {
            const PixelStar star = nearest_star(place, seen);
            moved = std::max(moved, star.moved);
            place = star.point;
            for (std::size_t i = 0; i < seen.size(); ++i)
                seen[i].coefficients = star.lines[i];
        }
        result.point =
            Eigen::Vector3d((place[0] - K(0, 2)) / K(0, 0), (place[1] - K(1, 2)) / K(1, 1), 1);
    }
    auto next = seen.begin();
    for (const auto& line : lines) {
        result.lines.emplace_back();
        if (line) result.lines.back() = (K.transpose() * (next++)->coefficients).normalized();
    }
    return result;
}

} // namespace plprove
