#include "prover/solver/condition.h"

#include "prover/solver/alignment.h"
#include "prover/solver/decompositions.h"
#include "prover/three_views/images.h"

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <limits>

namespace plprove {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double step = 1e-5; ///< of central differences: errors of about its square
constexpr double rounding = 1e-15;

/// The derivatives of f at 0, one column for each of its arguments.
MatrixXd jacobian(const std::function<VectorXd(const VectorXd&)>& f, Index arguments) {
    MatrixXd result(f(VectorXd::Zero(arguments)).size(), arguments);
    for (Index k = 0; k < arguments; ++k) {
        const VectorXd change = step * VectorXd::Unit(arguments, k);
        result.col(k) = (f(change) - f(-change)) / (2 * step);
    }
    return result;
}

/// The largest change of the cameras for a change of the images of length 1, where the equations
/// stay zero: the largest singular value of the derivatives of the cameras.
double largest_change(const MatrixXd& by_cameras, const MatrixXd& by_images) {
    const auto change = least_squares<double>(by_cameras, by_images, rounding);
    const auto squares = change ? eigensystem<double>(*change * change->transpose()) : std::nullopt;
    if (!squares) return std::numeric_limits<double>::infinity();
    return std::sqrt(squares->values.real().maxCoeff());
}

Matrix3d turned(const Matrix3d& R, const Vector3d& by) {
    const double angle = by.norm();
    if (angle == 0) return R;
    return Eigen::AngleAxisd(angle, by / angle).toRotationMatrix() * R;
}

/// The unit vectors, each moved along two directions that are orthogonal to it.
std::vector<Vector3d> moved(const std::vector<Vector3d>& images, const VectorXd& change) {
    std::vector<Vector3d> result;
    for (std::size_t i = 0; i < images.size(); ++i) {
        const Vector3d across = images[i].unitOrthogonal();
        const auto k = static_cast<Index>(2 * i);
        result.push_back(images[i] + change[k] * across + change[k + 1] * images[i].cross(across));
    }
    return result;
}

/// Directions in which a unit vector moves: an orthonormal basis of its complement. Zero for the
/// vector 0: where that is, no cameras are determined.
MatrixXd directions(const VectorXd& vector) {
    const auto basis = complement(vector, rounding);
    return basis ? *basis : MatrixXd::Zero(vector.size(), vector.size() - 1);
}

/// Three cameras near given ones: rotations turned, centres moved but for their scale.
struct Cameras {
    std::vector<Matrix3d> R;
    std::vector<Vector3d> centre;
};

Cameras near(const std::vector<Pose<double>>& poses, const VectorXd& change) {
    Cameras cameras;
    VectorXd centres(6);
    for (std::size_t v = 0; v < 3; ++v) {
        const Vector3d c = -poses[v].R.transpose() * poses[v].t;
        if (v > 0) centres.segment<3>(3 * static_cast<Index>(v) - 3) = c;
    }
    centres.normalize();
    centres += directions(centres) * change.tail<5>();
    for (std::size_t v = 0; v < 3; ++v) {
        const auto k = 3 * static_cast<Index>(v) - 3;
        cameras.R.push_back(v == 0 ? poses[v].R : turned(poses[v].R, change.segment<3>(k)));
        cameras.centre.push_back(v == 0 ? Vector3d::Zero().eval()
                                        : Vector3d(centres.segment<3>(k)));
    }
    return cameras;
}

/// The left hand side of an equation (certs/FORMAT.md, section 9).
double value(const CameraSystem& system, const CameraEquation& equation,
             const std::vector<Complex3>& vectors, const Cameras& cameras) {
    std::array<Vector3d, 3> d, c;
    const std::size_t count = equation.kind == EquationKind::epipolar ? 2 : 3;
    for (std::size_t k = 0; k < count; ++k) {
        const auto index = static_cast<std::size_t>(equation.vectors[k]);
        const auto view = static_cast<std::size_t>(system.vectors[index].view);
        const Complex3& x = vectors[index];
        d[k] = cameras.R[view].transpose() * Vector3d(x[0].real(), x[1].real(), x[2].real());
        c[k] = cameras.centre[view];
    }
    switch (equation.kind) {
    case EquationKind::epipolar:
        return (c[1] - c[0]).dot(d[0].cross(d[1]));
    case EquationKind::incidence:
        return d[1].dot(c[0] - c[1]) * d[2].dot(d[0]) - d[2].dot(c[0] - c[2]) * d[1].dot(d[0]);
    case EquationKind::pencil:
        return d[0].dot(d[1].cross(d[2]));
    }
    return 0;
}

VectorXd values(const CameraSystem& system, const std::vector<Vector3d>& images,
                const Cameras& cameras) {
    // The auxiliary lines and points do not matter to solutions, so neither to their derivatives.
    const std::vector<Complex3> constants(static_cast<std::size_t>(system.constants),
                                          {0.36, 0.48, 0.8});
    const std::vector<Complex3> vectors = image_vectors(system, constants, complex_images(images));
    VectorXd result(static_cast<Index>(system.equations.size()));
    for (std::size_t e = 0; e < system.equations.size(); ++e)
        result[static_cast<Index>(e)] = value(system, system.equations[e], vectors, cameras);
    return result;
}

} // namespace

double condition(const CameraSystem& system, const std::vector<Vector3d>& images,
                 const std::vector<Pose<double>>& poses) {
    const Cameras at = near(poses, VectorXd::Zero(11));
    const MatrixXd by_cameras = jacobian(
        [&](const VectorXd& change) { return values(system, images, near(poses, change)); }, 11);
    const MatrixXd by_images =
        jacobian([&](const VectorXd& change) { return values(system, moved(images, change), at); },
                 2 * std::ssize(images));
    return largest_change(by_cameras, by_images);
}

double condition(const std::vector<Vector3d>& first, const std::vector<Vector3d>& second,
                 const Pose<double>& pose) {
    const auto count = std::ssize(first);
    const auto epipolar = [&](const VectorXd& camera, const VectorXd& change) -> VectorXd {
        const std::vector<Vector3d> x = moved(first, change.head(2 * count));
        const std::vector<Vector3d> y = moved(second, change.tail(2 * count));
        const Matrix3d R = turned(pose.R, camera.head<3>());
        const VectorXd t = pose.t.normalized();
        const Vector3d translation = t + directions(t) * camera.tail<2>();
        VectorXd result(count);
        for (Index i = 0; i < count; ++i) {
            const auto k = static_cast<std::size_t>(i);
            result[i] = translation.dot((R * x[k]).cross(y[k]));
        }
        return result;
    };
    const MatrixXd by_camera = jacobian(
        [&](const VectorXd& camera) { return epipolar(camera, VectorXd::Zero(4 * count)); }, 5);
    const MatrixXd by_images = jacobian(
        [&](const VectorXd& change) { return epipolar(VectorXd::Zero(5), change); }, 4 * count);
    return largest_change(by_camera, by_images);
}

} // namespace plprove
