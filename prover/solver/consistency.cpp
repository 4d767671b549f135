#include "prover/solver/consistency.h"

#include <Eigen/Dense>
#include <algorithm>

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

} // namespace plprove
