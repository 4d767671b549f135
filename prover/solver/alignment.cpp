#include "prover/solver/alignment.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace plprove {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3cd;
using Eigen::Vector3d;

/// The number of modulus 1 that takes the image nearest to that of the start.
Complex best_phase(const Vector3d& image, const Vector3cd& start) {
    const Complex product = image.cast<Complex>().dot(start);
    const double size = std::abs(product);
    return size > 0 ? product / size : Complex(1);
}

/// The rotation for which the sum of Re(start · conj(image)), which the matrix holds, is largest
/// (W. Kabsch, 1976).
Matrix3d best_rotation(const Matrix3d& products) {
    const Eigen::JacobiSVD<Matrix3d> svd(products, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Matrix3d orthogonal = svd.matrixU() * svd.matrixV().transpose();
    const Vector3d signs(1, 1, orthogonal.determinant() > 0 ? 1 : -1);
    return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

std::vector<Vector3cd> vectors(const Images& images) {
    std::vector<Vector3cd> result;
    for (const Complex3& x : images)
        result.emplace_back(x[0], x[1], x[2]);
    return result;
}

using Quaternion = std::array<Complex, 4>;

Quaternion operator*(const Quaternion& p, const Quaternion& q) {
    return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
            p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
            p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
            p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
}

Quaternion quaternion(const Matrix3d& rotation) {
    const Eigen::Quaterniond q(rotation);
    return {q.w(), q.x(), q.y(), q.z()};
}

} // namespace

Images complex_images(const std::vector<Vector3d>& images) {
    Images result;
    for (const Vector3d& x : images)
        result.push_back({x[0], x[1], x[2]});
    return result;
}

Alignment align(const CameraSystem& system, const Images& start,
                const std::vector<Vector3d>& images) {
    constexpr int turns = 20;
    const std::vector<Vector3cd> targets = vectors(start);
    Alignment result;
    result.turn.fill(Matrix3d::Identity());
    result.turned = images;
    for (int turn = 0; turn < turns; ++turn) {
        std::array<Matrix3d, 3> products;
        products.fill(Matrix3d::Zero());
        for (std::size_t k = 0; k < images.size(); ++k) {
            const Complex phase = best_phase(result.turned[k], targets[k]);
            const Vector3d nearest = (targets[k] / phase).real();
            products[static_cast<std::size_t>(system.free[k].view)] +=
                nearest * images[k].transpose();
        }
        for (std::size_t v = 0; v < 3; ++v)
            result.turn[v] = best_rotation(products[v]);
        for (std::size_t k = 0; k < images.size(); ++k)
            result.turned[k] =
                result.turn[static_cast<std::size_t>(system.free[k].view)] * images[k];
    }
    for (std::size_t k = 0; k < images.size(); ++k) {
        const Complex phase = best_phase(result.turned[k], targets[k]);
        const Vector3d& x = result.turned[k];
        result.nearest.push_back({phase * x[0], phase * x[1], phase * x[2]});
    }
    return result;
}

QuaternionCameras turned_back(const std::array<Eigen::Matrix3d, 3>& turn,
                              const QuaternionCameras& cameras) {
    // A turned view sees Q x, so its camera has Q_v R_v Q_1^T and the centre Q_1 c.
    const Quaternion first = quaternion(turn[0]);
    const Matrix3d back = turn[0].transpose();
    QuaternionCameras result;
    for (std::size_t v = 0; v < 2; ++v) {
        const Quaternion inverse = quaternion(turn[v + 1].transpose());
        result.quaternion[v] = inverse * cameras.quaternion[v] * first;
        const Complex3& c = cameras.centre[v];
        const Vector3cd centre = back.cast<Complex>() * Vector3cd(c[0], c[1], c[2]);
        result.centre[v] = {centre[0], centre[1], centre[2]};
    }
    return result;
}

} // namespace plprove
