// Eigen's decompositions, for matrices of any size. Each takes the compiler ten seconds or more:
// they are compiled in one place, once for real and once for complex numbers.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>

namespace plprove {

template <class Scalar>
using AnyMatrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// Eigenvalues of a square matrix, and in the same order eigenvectors of length 1 as columns.
struct Eigensystem {
    Eigen::VectorXcd values;
    Eigen::MatrixXcd vectors;
};

/// Nothing where the iteration does not converge.
template <class Scalar>
std::optional<Eigensystem> eigensystem(const AnyMatrix<Scalar>& matrix);

/// The X with A X = B, for an invertible matrix A.
template <class Scalar>
AnyMatrix<Scalar> quotient(const AnyMatrix<Scalar>& a, const AnyMatrix<Scalar>& b);

/// The X that brings A X nearest to B; nothing where the columns of A are dependent, that is, where
/// a pivot is below the threshold, relative to the largest.
template <class Scalar>
std::optional<AnyMatrix<Scalar>> least_squares(const AnyMatrix<Scalar>& a,
                                               const AnyMatrix<Scalar>& b, double threshold);

/// An orthonormal basis of what is orthogonal to all columns; nothing where these are dependent, as
/// above.
std::optional<Eigen::MatrixXd> complement(const Eigen::MatrixXd& columns, double threshold);

/// Moore and Penrose's inverse.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix);

} // namespace plprove
