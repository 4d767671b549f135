#include "prover/many_views/cameras.h"

#include <Eigen/QR>

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

/// The affine space of vectors whose first entry is 1.
std::pair<VectorXcd, MatrixXcd> standard_slice(Index size) {
    return {VectorXcd::Unit(size, 0), MatrixXcd::Identity(size, size).rightCols(size - 1)};
}

/// Runs of numbers that count up to a factor are in a slice. What is not in one, and not fixed, is
/// a coordinate.
template <class Slice>
CameraChart::Chart make_chart(const CameraModel& model, bool second, const Slice& slice) {
    const Index size = model.numbers;
    CameraChart::Chart chart{VectorXcd::Zero(size), MatrixXcd::Zero(size, size)};
    Index number = 0, column = 0;
    if (second)
        for (const std::int64_t entry : model.start_of_second)
            chart.origin[number++] = static_cast<double>(entry);
    const auto coordinates_before = [&](Index end) {
        while (number < end)
            chart.basis(number++, column++) = 1;
    };
    for (const auto& [first, count] : model.scaled_runs(second)) {
        coordinates_before(first);
        const auto [origin, directions] = slice(Index{count});
        chart.origin.segment(first, count) = origin;
        chart.basis.block(first, column, count, count - 1) = directions;
        number += count;
        column += count - 1;
    }
    coordinates_before(size);
    chart.basis.conservativeResize(size, column);
    return chart;
}

Camera in_eigen(const CameraMatrix<Complex>& matrix) {
    Camera camera;
    for (Index i = 0; i < 3; ++i)
        for (Index j = 0; j < 4; ++j)
            camera(i, j) = matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    return camera;
}

} // namespace

void CameraChart::add(Chart chart) {
    offsets_.push_back(offsets_.back() + chart.basis.cols());
    charts_.push_back(std::move(chart));
}

CameraChart::CameraChart(const CameraModel& model, int views, Random& random) : CameraChart(model) {
    for (int view = 1; view < views; ++view)
        add(make_chart(model, view == 1, [&](Index size) { return random_slice(size, random); }));
}

CameraChart CameraChart::standard(const CameraModel& model, int views) {
    CameraChart result(model);
    for (int view = 1; view < views; ++view)
        result.add(make_chart(model, view == 1, standard_slice));
    return result;
}

VectorXcd CameraChart::numbers(std::size_t view, const VectorXcd& coordinates) const {
    const Chart& chart = charts_[view - 1];
    VectorXcd numbers(chart.origin.size() + shared());
    numbers << chart.origin +
                   chart.basis * coordinates.segment(offset(view), this->coordinates(view)),
        coordinates.head(shared());
    return numbers;
}

CameraWithDerivatives CameraChart::camera(std::size_t view, const VectorXcd& coordinates) const {
    const Chart& chart = charts_[view - 1];
    const VectorXcd numbers = this->numbers(view, coordinates);
    const auto derivative = [&](const VectorXcd& direction) {
        return in_eigen(model_->derivative(numbers.data(), direction.data()));
    };
    CameraWithDerivatives result{in_eigen(model_->matrix(numbers.data())), {}, {}};
    VectorXcd direction = VectorXcd::Zero(numbers.size());
    for (Index k = 0; k < chart.basis.cols(); ++k) {
        direction.head(chart.basis.rows()) = chart.basis.col(k);
        result.by_coordinate.push_back(derivative(direction));
    }
    for (Index k = chart.basis.rows(); k < numbers.size(); ++k)
        result.by_shared.push_back(derivative(VectorXcd::Unit(numbers.size(), k)));
    return result;
}

} // namespace plprove::many_views
