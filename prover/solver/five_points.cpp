#include "prover/solver/five_points.h"

#include <Eigen/Dense>

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

using Pencil = std::array<Matrix3d, 4>; ///< X, Y, Z, W
using Polynomials = std::array<std::array<Polynomial, 3>, 3>;

Polynomials essential_polynomials(const Pencil& pencil) {
    Polynomials e;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            e[i][j].setZero();
            for (std::size_t k = 0; k < 4; ++k)
                e[i][j][linear + static_cast<int>(k)] =
                    pencil[k](static_cast<int>(i), static_cast<int>(j));
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
Eigen::Matrix<double, 10, 20> cubics(const Pencil& pencil) {
    const Polynomials e = essential_polynomials(pencil);
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

/// The matrices E with y^T E x = 0 for all pairs; nothing where they are more than a pencil.
std::optional<Pencil> pencil_of(const std::array<Vector3d, 5>& first,
                                const std::array<Vector3d, 5>& second) {
    Eigen::Matrix<double, 9, 5> conditions;
    for (std::size_t k = 0; k < 5; ++k) {
        const Matrix3d product = second[k].normalized() * first[k].normalized().transpose();
        conditions.col(static_cast<int>(k)) = product.reshaped();
    }
    Eigen::ColPivHouseholderQR<Eigen::Matrix<double, 9, 5>> decomposition(conditions);
    decomposition.setThreshold(1e-10);
    if (decomposition.rank() < 5) return std::nullopt;
    const Eigen::Matrix<double, 9, 9> orthogonal = decomposition.householderQ();
    Pencil pencil;
    for (int k = 0; k < 4; ++k)
        pencil[static_cast<std::size_t>(k)] = orthogonal.col(5 + k).reshaped(3, 3);
    return pencil;
}

/// The matrix of multiplication by x; nothing where the cubes are no combinations of the basis.
std::optional<Eigen::Matrix<double, 10, 10>> multiplication(const Pencil& pencil) {
    const Eigen::Matrix<double, 10, 20> rows = cubics(pencil);
    const Eigen::PartialPivLU<Eigen::Matrix<double, 10, 10>> cubes(rows.leftCols<10>());
    const Eigen::Matrix<double, 10, 10> reduced = cubes.solve(rows.rightCols<10>());
    if (!reduced.allFinite()) return std::nullopt;
    Eigen::Matrix<double, 10, 10> action = Eigen::Matrix<double, 10, 10>::Zero();
    for (int i = 0; i < 10; ++i) {
        const int product = products[linear][static_cast<std::size_t>(basis + i)];
        if (product < basis)
            action.row(i) = -reduced.row(product);
        else
            action(i, product - basis) = 1;
    }
    return action;
}

/// The bilinear cross product. (Eigen's takes complex conjugates.)
Eigen::RowVector3cd cross(const Eigen::RowVector3cd& a, const Eigen::RowVector3cd& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// What the ten cubics leave of a matrix that is nearly essential.
Eigen::Matrix<Complex, 10, 1> defect(const Matrix3cd& E) {
    const Matrix3cd square = E * E.transpose();
    const Matrix3cd cubic = 2.0 * square * E - square.trace() * E;
    Eigen::Matrix<Complex, 10, 1> result;
    result << cubic.reshaped(), cross(E.row(0), E.row(1)).cwiseProduct(E.row(2)).sum();
    return result;
}

/// The same, differentiated along a direction.
Eigen::Matrix<Complex, 10, 1> defect(const Matrix3cd& E, const Matrix3cd& along) {
    const Matrix3cd square = E * E.transpose();
    const Matrix3cd change = along * E.transpose() + E * along.transpose();
    const Matrix3cd cubic =
        2.0 * (change * E + square * along) - change.trace() * E - square.trace() * along;
    Complex determinant = 0;
    for (int i = 0; i < 3; ++i)
        determinant +=
            cross(E.row((i + 1) % 3), E.row((i + 2) % 3)).cwiseProduct(along.row(i)).sum();
    Eigen::Matrix<Complex, 10, 1> result;
    result << cubic.reshaped(), determinant;
    return result;
}

Matrix3cd combine(const Pencil& pencil, const Eigen::Vector4cd& coefficients) {
    Matrix3cd sum = Matrix3cd::Zero();
    for (int k = 0; k < 4; ++k)
        sum += coefficients[k] * pencil[static_cast<std::size_t>(k)];
    return sum;
}

/// Newton's method on the pencil, from an approximate solution: what eigenvectors leave of rounding
/// goes.
Matrix3cd polished(const Pencil& pencil, Eigen::Vector4cd coefficients) {
    constexpr int steps = 2;
    for (int step = 0; step < steps; ++step) {
        coefficients.normalize();
        const Matrix3cd E = combine(pencil, coefficients);
        // The fourth equation keeps the length: steps are orthogonal to the coefficients.
        Eigen::Matrix<Complex, 11, 4> jacobian;
        Eigen::Matrix<Complex, 11, 1> right;
        for (int k = 0; k < 4; ++k)
            jacobian.col(k).head<10>() =
                defect(E, pencil[static_cast<std::size_t>(k)].cast<Complex>());
        jacobian.row(10) = coefficients.adjoint();
        right << -defect(E), Complex(0);
        const Eigen::Matrix4cd normal = jacobian.adjoint() * jacobian;
        const Eigen::Vector4cd change =
            Eigen::PartialPivLU<Eigen::Matrix4cd>(normal).solve(jacobian.adjoint() * right);
        if (change.allFinite()) coefficients += change;
    }
    return combine(pencil, coefficients.normalized());
}

/// The two poses with this essential matrix, by B. Horn's formula (1990), which holds for complex
/// matrices as well: (t·t) R = cof(E) - [t] E.
void append_poses(const Matrix3cd& E, std::vector<ComplexPose>& poses) {
    const Matrix3cd square = E * E.transpose();
    const Matrix3cd tt = 0.5 * square.trace() * Matrix3cd::Identity() - square;
    Eigen::Index largest = 0;
    tt.diagonal().cwiseAbs().maxCoeff(&largest);
    const Eigen::Vector3cd t = tt.col(largest) / std::sqrt(tt(largest, largest));
    Matrix3cd cofactors, skew;
    cofactors << cross(E.row(1), E.row(2)), cross(E.row(2), E.row(0)), cross(E.row(0), E.row(1));
    skew << 0, -t[2], t[1], t[2], 0, -t[0], -t[1], t[0], 0;
    const Complex norm = t.cwiseProduct(t).sum();
    if (std::abs(norm) < 1e-9 * t.squaredNorm()) return; // isotropic: no translation
    for (const double sign : {1.0, -1.0}) {
        const Matrix3cd R = (cofactors - sign * skew * E) / norm;
        poses.push_back({R, sign * t});
    }
}

} // namespace

std::vector<ComplexPose> five_point_poses(const std::array<Vector3d, 5>& first,
                                          const std::array<Vector3d, 5>& second) {
    std::vector<ComplexPose> poses;
    const auto pencil = pencil_of(first, second);
    if (!pencil) return poses;
    const auto action = multiplication(*pencil);
    if (!action) return poses;
    const Eigen::EigenSolver<Eigen::Matrix<double, 10, 10>> solver(*action);
    if (solver.info() != Eigen::Success) return poses;
    const auto vectors = solver.eigenvectors();
    for (int k = 0; k < 10; ++k) {
        const Eigen::Vector4cd coefficients = vectors.col(k).tail<4>();
        if (coefficients.norm() > 0) append_poses(polished(*pencil, coefficients), poses);
    }
    return poses;
}

} // namespace plprove
