#include "prover/solver/decompositions.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace plprove {

template <class Scalar>
std::optional<Eigensystem> eigensystem(const AnyMatrix<Scalar>& matrix) {
    using Solver =
        std::conditional_t<std::is_same_v<Scalar, double>, Eigen::EigenSolver<Eigen::MatrixXd>,
                           Eigen::ComplexEigenSolver<Eigen::MatrixXcd>>;
    const Solver solver(matrix);
    if (solver.info() != Eigen::Success) return std::nullopt;
    return Eigensystem{solver.eigenvalues(), solver.eigenvectors()};
}

template <class Scalar>
AnyMatrix<Scalar> quotient(const AnyMatrix<Scalar>& a, const AnyMatrix<Scalar>& b) {
    return a.householderQr().solve(b);
}

template <class Scalar>
std::optional<AnyMatrix<Scalar>> least_squares(const AnyMatrix<Scalar>& a,
                                               const AnyMatrix<Scalar>& b, double threshold) {
    Eigen::ColPivHouseholderQR<AnyMatrix<Scalar>> decomposition(a);
    decomposition.setThreshold(threshold);
    if (decomposition.rank() < a.cols()) return std::nullopt;
    return decomposition.solve(b);
}

std::optional<Eigen::MatrixXd> complement(const Eigen::MatrixXd& columns, double threshold) {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(columns);
    decomposition.setThreshold(threshold);
    if (decomposition.rank() < columns.cols()) return std::nullopt;
    const Eigen::MatrixXd orthogonal = decomposition.householderQ();
    return orthogonal.rightCols(columns.rows() - columns.cols());
}

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix) {
    return matrix.completeOrthogonalDecomposition().pseudoInverse();
}

using Eigen::MatrixXcd, Eigen::MatrixXd;
template std::optional<Eigensystem> eigensystem<double>(const MatrixXd&);
template std::optional<Eigensystem> eigensystem<std::complex<double>>(const MatrixXcd&);
template MatrixXd quotient<double>(const MatrixXd&, const MatrixXd&);
template MatrixXcd quotient<std::complex<double>>(const MatrixXcd&, const MatrixXcd&);
template std::optional<MatrixXd> least_squares<double>(const MatrixXd&, const MatrixXd&, double);
template std::optional<MatrixXcd> least_squares<std::complex<double>>(const MatrixXcd&,
                                                                      const MatrixXcd&, double);

} // namespace plprove
