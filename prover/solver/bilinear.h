// Products of vectors that may be complex, without complex conjugates: what is orthogonal to what
// is said by polynomials. (Eigen's products take conjugates.)
#pragma once

#include <Eigen/Core>
#include <complex>

namespace plprove {

template <class Scalar>
using Vector = Eigen::Matrix<Scalar, 3, 1>;

template <class Scalar>
Scalar bilinear(const Vector<Scalar>& a, const Vector<Scalar>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Scalar>
Vector<Scalar> bilinear_cross(const Vector<Scalar>& a, const Vector<Scalar>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The determinant of the three as rows.
template <class Scalar>
Scalar determinant(const Vector<Scalar>& a, const Vector<Scalar>& b, const Vector<Scalar>& c) {
    return bilinear<Scalar>(a, bilinear_cross<Scalar>(b, c));
}

} // namespace plprove
