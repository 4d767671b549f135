#include "prover/many_views/cameras.h"

#include <Eigen/QR>
#include <algorithm>

namespace plprove::many_views {

namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;

VectorXcd random_vector(Index size, Random& random) {
    VectorXcd vector(size);
    for (Complex& x : vector)
        x = random.complex();
    return vector.normalized();
}

/// The affine space of vectors with a · r = 1, in orthonormal coordinates.
std::pair<VectorXcd, MatrixXcd> random_slice(Index size, Random& random) {
    const VectorXcd normal = random_vector(size, random);
    const Eigen::HouseholderQR<MatrixXcd> decomposition(normal);
    const MatrixXcd orthonormal = decomposition.householderQ() * MatrixXcd::Identity(size, size);
    return {normal, orthonormal.rightCols(size - 1)};
}

using Quaternion = Eigen::Vector4cd;
using Matrix3 = Eigen::Matrix3cd;

/// The bilinear form whose values at (q, q) are the matrix of the quaternion, times its norm.
Matrix3 rotation(const Quaternion& p, const Quaternion& q) {
    const auto sum = [&](Index i, Index j) { return p[i] * q[j] + p[j] * q[i]; };
    Matrix3 R;
    const Complex aa = p[0] * q[0], bb = p[1] * q[1], cc = p[2] * q[2], dd = p[3] * q[3];
    R << aa + bb - cc - dd, sum(1, 2) - sum(0, 3), sum(1, 3) + sum(0, 2), //
        sum(1, 2) + sum(0, 3), aa - bb + cc - dd, sum(2, 3) - sum(0, 1),  //
        sum(1, 3) - sum(0, 2), sum(2, 3) + sum(0, 1), aa - bb - cc + dd;
    return R;
}

Camera joined(const Matrix3& M, const Eigen::Vector3cd& t) {
    Camera camera;
    camera << M, t;
    return camera;
}

/// Row by row.
Camera matrix(const VectorXcd& entries) {
    return entries.reshaped<Eigen::RowMajor>(3, 4);
}

} // namespace

CameraChart::Chart CameraChart::calibrated(bool second, Random& random) {
    const auto [quaternion, directions] = random_slice(4, random);
    Chart chart{VectorXcd::Zero(7), MatrixXcd::Zero(7, second ? 5 : 6)};
    chart.origin.head(4) = quaternion;
    chart.basis.topLeftCorner(4, 3) = directions;
    if (second) {
        const auto [translation, across] = random_slice(3, random);
        chart.origin.tail(3) = translation;
        chart.basis.bottomRightCorner(3, 2) = across;
    } else {
        chart.basis.bottomRightCorner(3, 3).setIdentity();
    }
    return chart;
}

CameraChart::Chart CameraChart::projective(bool second, Random& random) {
    const Index fixed = second ? 4 : 0; // entries of the first row
    const auto [origin, basis] = random_slice(12 - fixed, random);
    Chart chart{VectorXcd::Zero(12), MatrixXcd::Zero(12, basis.cols())};
    if (second) chart.origin[3] = 1;
    chart.origin.tail(12 - fixed) = origin;
    chart.basis.bottomRows(12 - fixed) = basis;
    return chart;
}

void CameraChart::add(Chart chart) {
    offsets_.push_back(offsets_.back() + chart.basis.cols());
    charts_.push_back(std::move(chart));
}

CameraChart::CameraChart(const CameraModel& model, int views, Random& random) : model_(&model) {
    for (int view = 1; view < views; ++view)
        add(&model == &calibrated_cameras ? calibrated(view == 1, random)
                                          : projective(view == 1, random));
}

CameraChart CameraChart::standard(const CameraModel& model, int views) {
    CameraChart result(model);
    const bool calibrated = &model == &calibrated_cameras;
    for (int view = 1; view < views; ++view) {
        std::vector<Index> ones{0}, free;
        if (calibrated && view == 1) ones = {0, 4};
        if (!calibrated && view == 1) ones = {3, 4};
        const Index first = !calibrated && view == 1 ? 4 : 0; // entries before are fixed
        const Index size = calibrated ? 7 : 12;
        for (Index n = first; n < size; ++n)
            if (std::ranges::find(ones, n) == ones.end()) free.push_back(n);
        Chart chart{VectorXcd::Zero(size), MatrixXcd::Zero(size, std::ssize(free))};
        for (const Index n : ones)
            chart.origin[n] = 1;
        for (std::size_t k = 0; k < free.size(); ++k)
            chart.basis(free[k], static_cast<Index>(k)) = 1;
        result.add(std::move(chart));
    }
    return result;
}

VectorXcd CameraChart::numbers(std::size_t view, const VectorXcd& coordinates) const {
    const Chart& chart = charts_[view - 1];
    return chart.origin + chart.basis * coordinates;
}

CameraWithDerivatives CameraChart::camera(std::size_t view, const VectorXcd& coordinates) const {
    const Chart& chart = charts_[view - 1];
    const VectorXcd numbers = this->numbers(view, coordinates);
    CameraWithDerivatives result;
    if (model_ == &projective_cameras) {
        result.camera = matrix(numbers);
        for (Index k = 0; k < chart.basis.cols(); ++k)
            result.by_coordinate.push_back(matrix(chart.basis.col(k)));
        return result;
    }
    const Quaternion q = numbers.head<4>();
    result.camera = joined(rotation(q, q), numbers.tail<3>());
    for (Index k = 0; k < chart.basis.cols(); ++k) {
        const VectorXcd direction = chart.basis.col(k);
        result.by_coordinate.push_back(
            joined(2.0 * rotation(q, direction.head<4>()), direction.tail<3>()));
    }
    return result;
}

} // namespace plprove::many_views
