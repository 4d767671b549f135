#include "prover/solver/five_points.h"

#include "prover/solver/bilinear.h"
#include "prover/solver/decompositions.h"

#include <Eigen/LU>

namespace plprove {

namespace {

using Complex = std::complex<double>;
using Eigen::Matrix3cd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The monomials in x, y, z of degree at most 3 by their exponents: those of degree 3 first, then
/// the basis of the quotient.
constexpr std::array<std::array<int, 3>, 20> monomials{
    {{3, 0, 0}, {2, 1, 0}, {2, 0, 1}, {1, 2, 0}, {1, 1, 1}, {1, 0, 2}, {0, 3, 0},
     {0, 2, 1}, {0, 1, 2}, {0, 0, 3}, {2, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 2, 0},
     {0, 1, 1}, {0, 0, 2}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};

constexpr int linear = 16; ///< where the monomials x, y, z, 1 begin
constexpr int basis = 10;  ///< where the basis of the quotient begins

constexpr int index_of(int x, int y, int z) {
    for (int i = 0; i < 20; ++i)
        if (monomials[static_cast<std::size_t>(i)] == std::array{x, y, z}) return i;
    return -1; // of degree 4 or more
}

/// The place of the product of two monomials.
constexpr auto products = [] {
    std::array<std::array<int, 20>, 20> table{};
    for (std::size_t i = 0; i < 20; ++i)
        for (std::size_t j = 0; j < 20; ++j)
            table[i][j] =
                index_of(monomials[i][0] + monomials[j][0], monomials[i][1] + monomials[j][1],
                         monomials[i][2] + monomials[j][2]);
    return table;
}();

/// A polynomial whose coefficients are those of the monomials.
using Polynomial = Eigen::Matrix<double, 20, 1>;

/// The product, where the first factor is of degree 1, and the second begins at this monomial.
Polynomial times(const Polynomial& a, const Polynomial& b, int begin) {
    Polynomial result = Polynomial::Zero();
    for (int i = linear; i < 20; ++i)
        for (int j = begin; j < 20; ++j)
            result[products[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]] +=
                a[i] * b[j];
    return result;
}

/// Matrices X, Y, Z, W. The essential matrices are combinations x X + y Y + z Z + W of them.
using NullSpace = std::array<Matrix3d, 4>;
using Polynomials = std::array<std::array<Polynomial, 3>, 3>;

Polynomials essential_polynomials(const NullSpace& space) {
    Polynomials e;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            e[i][j].setZero();
            for (std::size_t k = 0; k < 4; ++k)
                e[i][j][linear + static_cast<int>(k)] =
                    space[k](static_cast<int>(i), static_cast<int>(j));
        }
    return e;
}

Polynomial determinant(const Polynomials& e) {
    Polynomial sum = Polynomial::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
        const Polynomial minor = times(e[1][a], e[2][b], linear) - times(e[1][b], e[2][a], linear);
        sum += times(e[0][k], minor, basis);
    }
    return sum;
}

/// The rows of the ten cubics: det E = 0 and 2 E E^T E - trace(E E^T) E = 0.
Eigen::Matrix<double, 10, 20> cubics(const NullSpace& space) {
    const Polynomials e = essential_polynomials(space);
    Polynomials square; // E E^T - trace / 2
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = i; j < 3; ++j) {
            square[i][j].setZero();
            for (std::size_t k = 0; k < 3; ++k)
                square[i][j] += times(e[i][k], e[j][k], linear);
            square[j][i] = square[i][j];
        }
    const Polynomial half_trace = 0.5 * (square[0][0] + square[1][1] + square[2][2]);
    for (std::size_t i = 0; i < 3; ++i)
        square[i][i] -= half_trace;
    Eigen::Matrix<double, 10, 20> rows;
    rows.row(0) = determinant(e).transpose();
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            Polynomial sum = Polynomial::Zero();
            for (std::size_t k = 0; k < 3; ++k)
                sum += times(e[k][j], square[i][k], basis);
            rows.row(static_cast<int>(1 + 3 * i + j)) = sum.transpose();
        }
    return rows;
}

/// A basis of the matrices E with y^T E x = 0 for all pairs; nothing where it has more than four.
std::optional<NullSpace> null_space(const std::array<Vector3d, 5>& first,
                                    const std::array<Vector3d, 5>& second) {
    Eigen::MatrixXd conditions(9, 5);
    for (std::size_t k = 0; k < 5; ++k) {
        const Matrix3d product = second[k].normalized() * first[k].normalized().transpose();
        conditions.col(static_cast<int>(k)) = product.reshaped();
    }
    const auto matrices = complement(conditions, 1e-10);
    if (!matrices) return std::nullopt;
    NullSpace space;
    for (int k = 0; k < 4; ++k)
        space[static_cast<std::size_t>(k)] = matrices->col(k).reshaped(3, 3);
    return space;
}

/// The matrix of multiplication by x; nothing where the cubes are no combinations of the basis.
std::optional<Eigen::MatrixXd> multiplication(const NullSpace& space) {
    const Eigen::Matrix<double, 10, 20> rows = cubics(space);
    const Eigen::MatrixXd reduced = quotient<double>(rows.leftCols<10>(), rows.rightCols<10>());
    if (!reduced.allFinite()) return std::nullopt;
    Eigen::MatrixXd action = Eigen::MatrixXd::Zero(10, 10);
    for (int i = 0; i < 10; ++i) {
        const int product = products[linear][static_cast<std::size_t>(basis + i)];
        if (product < basis)
            action.row(i) = -reduced.row(product);
        else
            action(i, product - basis) = 1;
    }
    return action;
}

template <class Scalar>
using Matrix3 = Eigen::Matrix<Scalar, 3, 3>;
template <class Scalar>
using Vector4 = Eigen::Matrix<Scalar, 4, 1>;

/// The matrix of cofactors.
template <class Scalar>
Matrix3<Scalar> cofactors(const Matrix3<Scalar>& E) {
    Matrix3<Scalar> result;
    for (int i = 0; i < 3; ++i) {
        const Vector<Scalar> next = E.row((i + 1) % 3).transpose();
        const Vector<Scalar> last = E.row((i + 2) % 3).transpose();
        result.row(i) = bilinear_cross<Scalar>(next, last).transpose();
    }
    return result;
}

/// The ten cubics at a matrix that is nearly essential, and their derivatives.
template <class Scalar>
class Cubics {
public:
    using Values = Eigen::Matrix<Scalar, 10, 1>;

    explicit Cubics(const Matrix3<Scalar>& E)
        : E_(E), square_(E * E.transpose()), cofactors_(cofactors<Scalar>(E)) {}

    Values values() const {
        const Matrix3<Scalar> cubic = Scalar(2) * square_ * E_ - square_.trace() * E_;
        return joined(cubic, cofactors_.row(0).cwiseProduct(E_.row(0)).sum());
    }

    /// Along a direction.
    Values derivatives(const Matrix3<Scalar>& along) const {
        const Matrix3<Scalar> product = along * E_.transpose();
        const Matrix3<Scalar> change = product + product.transpose();
        const Matrix3<Scalar> cubic = Scalar(2) * (change * E_ + square_ * along) -
                                      change.trace() * E_ - square_.trace() * along;
        return joined(cubic, cofactors_.cwiseProduct(along).sum());
    }

private:
    static Values joined(const Matrix3<Scalar>& cubic, const Scalar& determinant) {
        Values result;
        result << cubic.reshaped(), determinant;
        return result;
    }

    Matrix3<Scalar> E_, square_, cofactors_;
};

template <class Scalar>
Matrix3<Scalar> combine(const NullSpace& space, const Vector4<Scalar>& coefficients) {
    Matrix3<Scalar> sum = Matrix3<Scalar>::Zero();
    for (int k = 0; k < 4; ++k)
        sum += coefficients[k] * space[static_cast<std::size_t>(k)];
    return sum;
}

/// Newton's method in the null space, from an approximate solution: what eigenvectors leave of
/// rounding goes.
template <class Scalar>
Matrix3<Scalar> polished(const NullSpace& space, Vector4<Scalar> coefficients) {
    constexpr int most_steps = 2;
    constexpr double small = 1e-8; // after such a step the next one changes nothing
    double change_size = 1;
    for (int step = 0; step < most_steps && change_size > small; ++step) {
        coefficients.normalize();
        const Cubics<Scalar> cubics(combine<Scalar>(space, coefficients));
        // The last equation keeps the length: steps are orthogonal to the coefficients.
        Eigen::Matrix<Scalar, 11, 4> jacobian;
        for (int k = 0; k < 4; ++k)
            jacobian.col(k).template head<10>() =
                cubics.derivatives(space[static_cast<std::size_t>(k)].template cast<Scalar>());
        jacobian.row(10) = coefficients.adjoint();
        Eigen::Matrix<Scalar, 11, 1> right;
        right << -cubics.values(), Scalar(0);
        const Eigen::Matrix<Scalar, 4, 4> normal = jacobian.adjoint() * jacobian;
        const Vector4<Scalar> change = normal.inverse() * (jacobian.adjoint() * right);
        if (!change.allFinite()) break;
        coefficients += change;
        change_size = change.norm();
    }
    return combine<Scalar>(space, coefficients.normalized());
}

/// The two poses with this essential matrix, by B. Horn's formula (1990), which holds for complex
/// matrices as well: (t·t) R = cof(E) - [t] E.
void append_poses(const Matrix3cd& E, std::vector<ComplexPose>& poses) {
    const Matrix3cd square = E * E.transpose();
    const Matrix3cd tt = 0.5 * square.trace() * Matrix3cd::Identity() - square;
    Eigen::Index largest = 0;
    tt.diagonal().cwiseAbs().maxCoeff(&largest);
    const Eigen::Vector3cd t = tt.col(largest) / std::sqrt(tt(largest, largest));
    Matrix3cd skew;
    skew << 0, -t[2], t[1], t[2], 0, -t[0], -t[1], t[0], 0;
    const Complex norm = t.cwiseProduct(t).sum();
    if (std::abs(norm) < 1e-9 * t.squaredNorm()) return; // isotropic: no translation
    for (const double sign : {1.0, -1.0}) {
        const Matrix3cd R = (cofactors<Complex>(E) - sign * skew * E) / norm;
        poses.push_back({R, sign * t});
    }
}

} // namespace

std::vector<ComplexPose> five_point_poses(const std::array<Vector3d, 5>& first,
                                          const std::array<Vector3d, 5>& second) {
    std::vector<ComplexPose> poses;
    const auto space = null_space(first, second);
    if (!space) return poses;
    const auto action = multiplication(*space);
    if (!action) return poses;
    const auto found = eigensystem<double>(*action);
    if (!found) return poses;
    for (int k = 0; k < 10; ++k) {
        const Eigen::Vector4cd coefficients = found->vectors.col(k).tail<4>();
        const double imaginary = found->values[k].imag();
        if (coefficients.norm() == 0 || imaginary < 0) continue; // the conjugate of another one
        if (imaginary == 0) {
            const Matrix3d E = polished<double>(*space, coefficients.real());
            append_poses(E.cast<Complex>(), poses);
        } else {
            const Matrix3cd E = polished<Complex>(*space, coefficients);
            append_poses(E, poses);
            append_poses(E.conjugate(), poses);
        }
    }
    return poses;
}

} // namespace plprove
