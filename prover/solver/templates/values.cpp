#include "prover/solver/templates/values.h"

#include "prover/solver/decompositions.h"
#include "prover/solver/templates/system.h"

namespace plprove {

namespace {

template <class Scalar>
templates::System<Scalar, KnownScene<Scalar>>
system_at(const KnownScene<Scalar>& scene, templates::Frame frame,
          const Eigen::Matrix<Scalar, 3, 3>& rotation) {
    std::array<Scalar, 9> entries;
    for (Eigen::Index i = 0; i < 9; ++i)
        entries[static_cast<std::size_t>(i)] = rotation(i / 3, i % 3);
    return {scene, frame, entries, Scalar(1)};
}

} // namespace

template <class Scalar>
std::vector<Scalar> equation_values(const KnownScene<Scalar>& scene, templates::Frame frame,
                                    const Eigen::Matrix<Scalar, 3, 3>& rotation) {
    auto system = system_at(scene, frame, rotation);
    system.add_minors();
    return system.equations();
}

template std::vector<double> equation_values(const KnownScene<double>&, templates::Frame,
                                             const Eigen::Matrix3d&);
template std::vector<Complex> equation_values(const KnownScene<Complex>&, templates::Frame,
                                              const Eigen::Matrix3cd&);

Eigen::Vector3cd translation(const KnownScene<Complex>& scene, const Eigen::Matrix3cd& rotation) {
    const auto system = system_at(scene, templates::Frame::general, rotation);
    const auto rows = static_cast<Eigen::Index>(system.conditions().size());
    Eigen::MatrixXcd linear(rows, 3), free(rows, 1);
    for (Eigen::Index row = 0; row < rows; ++row) {
        const auto& condition = system.conditions()[static_cast<std::size_t>(row)];
        const auto& [a, b, c] = condition.linear;
        const Eigen::Vector3cd coefficients(a, b, c);
        const double size = coefficients.norm();
        linear.row(row) = coefficients.transpose() / size;
        free(row, 0) = condition.free / size;
    }
    constexpr double rounding = 1e-15;
    const auto found = least_squares<Complex>(linear, -free, rounding);
    return found ? Eigen::Vector3cd(found->col(0)) : Eigen::Vector3cd::Zero();
}

} // namespace plprove
