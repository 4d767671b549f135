// Cameras in coordinates: one for each parameter, in a random chart.
#pragma once

#include "prover/problem/problem.h"
#include "prover/three_views/random.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace plprove::many_views {

/// [M | t], of a view but the first.
using Camera = Eigen::Matrix<Complex, 3, 4>;

/// A camera and its derivatives by its coordinates, and by the shared numbers.
struct CameraWithDerivatives {
    Camera camera;
    std::vector<Camera> by_coordinate;
    std::vector<Camera> by_shared;
};

/// Affine coordinates of the cameras 2, 3, ...: the shared numbers, and those of each camera; of
/// each run of numbers that count up to a common factor, in an affine space that misses 0. Motions
/// and scalings of space leave no freedom.
class CameraChart {
public:
    CameraChart(const CameraModel& model, int views, Random& random);

    /// The one of certs/FORMAT.md, section 14: that of normalised cameras.
    static CameraChart standard(const CameraModel& model, int views);

    /// A camera's own numbers: origin + basis · coordinates.
    struct Chart {
        Eigen::VectorXcd origin;
        Eigen::MatrixXcd basis;
    };

    int views() const { return static_cast<int>(charts_.size()) + 1; }
    const Chart& chart(std::size_t view) const { return charts_[view - 1]; }
    /// How many numbers all cameras share: the first coordinates.
    Eigen::Index shared() const { return offsets_.front(); }
    /// The number of coordinates of the camera of a view (1, 2, ...), and of those before.
    Eigen::Index coordinates(std::size_t view) const { return charts_[view - 1].basis.cols(); }
    Eigen::Index offset(std::size_t view) const { return offsets_[view - 1]; }
    /// Of all cameras.
    Eigen::Index dimension() const { return offsets_.back(); }

    /// The numbers that make a camera, shared ones last, at these coordinates of all cameras.
    Eigen::VectorXcd numbers(std::size_t view, const Eigen::VectorXcd& coordinates) const;

    CameraWithDerivatives camera(std::size_t view, const Eigen::VectorXcd& coordinates) const;

private:
    explicit CameraChart(const CameraModel& model) : model_(&model), offsets_{model.shared} {}

    void add(Chart chart);

    const CameraModel* model_;
    std::vector<Chart> charts_;
    std::vector<Eigen::Index> offsets_; ///< and the sum of all
};

} // namespace plprove::many_views
