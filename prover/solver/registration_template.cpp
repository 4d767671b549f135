#include "prover/solver/registration_template.h"

#include "prover/solver/decompositions.h"
#include "prover/solver/rotation.h"
#include "prover/solver/templates/values.h"
#include "prover/three_views/random.h"

#include <Eigen/LU>
#include <algorithm>

namespace plprove {

namespace {

using Eigen::Matrix3cd;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using templates::BiDegree;
using templates::Frame;
using templates::Monomial;
using templates::Polynomial;

/// Residues of small integers.
double signed_value(Residue x) {
    return x > modulus / 2 ? -static_cast<double>(modulus - x) : static_cast<double>(x);
}

double value(const Monomial& monomial, const Eigen::Vector4d& coordinates) {
    double product = 1;
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < monomial[static_cast<std::size_t>(i)]; ++k)
            product *= coordinates[i];
    return product;
}

/// The rotation with these coordinates: a quaternion, or (c, s, c', s').
template <class Scalar>
Eigen::Matrix<Scalar, 3, 3> rotation_of(Frame frame, const Eigen::Matrix<Scalar, 4, 1>& u) {
    if (frame == Frame::general)
        return rotation_of_quaternion(std::array<Scalar, 4>{u[0], u[1], u[2], u[3]});
    const Scalar c = u[0], s = u[1], c2 = u[2], s2 = u[3];
    Eigen::Matrix<Scalar, 3, 3> rotation;
    rotation << c, -s * c2, s * s2, s, c * c2, -c * s2, Scalar(0), s2, c2;
    return rotation;
}

/// The coordinates of a random rotation.
Eigen::Vector4d random_coordinates(Frame frame, Random& random) {
    Eigen::Vector4d u;
    do
        for (int i = 0; i < 4; ++i)
            u[i] = random.real();
    while (u.norm() > 1 || u.head<2>().norm() < 0.1 || u.tail<2>().norm() < 0.1);
    if (frame == Frame::general) return u.normalized();
    u.head<2>().normalize();
    u.tail<2>().normalize();
    return u;
}

constexpr Monomial one{0, 0, 0, 0};

/// The monomials whose values give the rotation, 1 first: of degree 2 in the quaternion, from the
/// product of the first two coordinates on, in lexicographic order of the factors; or the
/// coordinates of the circles.
std::vector<Monomial> unit_monomials(Frame frame) {
    std::vector<Monomial> units{one};
    for (std::size_t i = 0; i < 4; ++i) {
        if (frame != Frame::general) {
            units.push_back(one);
            ++units.back()[i];
            continue;
        }
        for (std::size_t j = std::max<std::size_t>(i, 1); j < 4; ++j) {
            units.push_back(one);
            ++units.back()[i];
            ++units.back()[j];
        }
    }
    return units;
}

} // namespace

RegistrationTemplate::RegistrationTemplate(const templates::Template& found)
    : frame_(found.frame), ring_(found.frame), solutions_(static_cast<int>(found.basis.size())) {
    const std::vector<Monomial> monomials = ring_.monomials(found.degree);
    for (std::size_t i = 0; i < monomials.size(); ++i)
        columns_[monomials[i]] = static_cast<int>(i);
    const auto equations = templates::equations(found.data, frame_);
    std::size_t most = 0; // monomials of an equation
    for (const auto& [number, multipliers] : found.rows)
        most = std::max(most, ring_.monomials(equations[number].degree).size());
    draw_samples(2 * most);
    for (const auto& [number, multipliers] : found.rows) {
        const BiDegree& degree = equations[number].degree;
        used_.push_back({number, interpolation(degree)});
        for (const std::size_t multiplier : multipliers)
            add_row(degree, monomials[multiplier]);
    }
    add_products(found.degree);
}

/// The last equation of used_ times a monomial.
void RegistrationTemplate::add_row(const BiDegree& degree, const Monomial& multiplier) {
    Row& row = rows_.emplace_back();
    row.equation = used_.size() - 1;
    const std::vector<Monomial> monomials = ring_.monomials(degree);
    for (std::size_t k = 0; k < monomials.size(); ++k) {
        const Polynomial product = ring_.product({{monomials[k], 1}}, {{multiplier, 1}});
        for (const Term& term : terms(product, static_cast<int>(k)))
            row.terms.push_back(term);
    }
}

/// g and h are random, so that solutions are told apart and h vanishes at none.
void RegistrationTemplate::add_products(const BiDegree& degree) {
    const std::vector<Monomial> units = unit_monomials(frame_);
    Random random(0, 1);
    for (std::size_t i = 0; i < units.size(); ++i) {
        g_.push_back(random.real());
        h_.push_back(random.real());
    }
    for (const auto& [monomial, column] : columns_) {
        if (!templates::at_most(templates::sum(ring_.degree(monomial), ring_.unit()), degree))
            continue;
        auto& products = products_.emplace_back();
        for (const Monomial& unit : units)
            products.push_back(terms(ring_.product({{unit, 1}}, {{monomial, 1}}), 0));
    }
}

void RegistrationTemplate::draw_samples(std::size_t count) {
    Random random(0, 0);
    for (std::size_t i = 0; i < count; ++i) {
        samples_.push_back(random_coordinates(frame_, random));
        sample_rotations_.push_back(rotation_of<double>(frame_, samples_.back()));
    }
}

RegistrationTemplate::Terms RegistrationTemplate::terms(const Polynomial& polynomial,
                                                        int coefficient) const {
    Terms result;
    for (const auto& [monomial, x] : polynomial)
        result.push_back({columns_.at(monomial), coefficient, signed_value(x)});
    return result;
}

std::size_t RegistrationTemplate::interpolation(const BiDegree& degree) {
    const auto known = std::ranges::find(degrees_, degree);
    if (known != degrees_.end()) return static_cast<std::size_t>(known - degrees_.begin());
    const std::vector<Monomial> monomials = ring_.monomials(degree);
    MatrixXd values(static_cast<Eigen::Index>(samples_.size()),
                    static_cast<Eigen::Index>(monomials.size()));
    for (std::size_t s = 0; s < samples_.size(); ++s)
        for (std::size_t k = 0; k < monomials.size(); ++k)
            values(static_cast<Eigen::Index>(s), static_cast<Eigen::Index>(k)) =
                value(monomials[k], samples_[s]);
    degrees_.push_back(degree);
    interpolations_.push_back(pseudo_inverse(values));
    return degrees_.size() - 1;
}

template <class Scalar>
std::vector<Eigen::Matrix<Scalar, Eigen::Dynamic, 1>>
RegistrationTemplate::coefficients(const KnownScene<Scalar>& scene) const {
    Matrix<Scalar> values(static_cast<Eigen::Index>(samples_.size()),
                          static_cast<Eigen::Index>(used_.size()));
    for (std::size_t s = 0; s < samples_.size(); ++s) {
        const auto all =
            equation_values<Scalar>(scene, frame_, sample_rotations_[s].template cast<Scalar>());
        for (std::size_t e = 0; e < used_.size(); ++e)
            values(static_cast<Eigen::Index>(s), static_cast<Eigen::Index>(e)) =
                all[used_[e].number];
    }
    std::vector<Eigen::Matrix<Scalar, Eigen::Dynamic, 1>> result;
    for (std::size_t e = 0; e < used_.size(); ++e) {
        result.emplace_back(interpolations_[used_[e].degree] *
                            values.col(static_cast<Eigen::Index>(e)));
        result.back().normalize();
    }
    return result;
}

/// A basis of the null space as columns, one row for each monomial.
template <class Scalar>
RegistrationTemplate::Matrix<Scalar>
RegistrationTemplate::null_space(const KnownScene<Scalar>& scene) const {
    const auto equations = coefficients<Scalar>(scene);
    const auto columns = static_cast<Eigen::Index>(columns_.size());
    const Eigen::Index rows = size(), rest = columns - rows;
    // Columns become rows, so that pivoting chooses among them: P transposed = L U. What is not
    // chosen is the basis. Zeros make the matrix square.
    Matrix<Scalar> transposed = Matrix<Scalar>::Zero(columns, columns);
    for (Eigen::Index r = 0; r < rows; ++r) {
        const Row& row = rows_[static_cast<std::size_t>(r)];
        for (const Term& term : row.terms)
            transposed(term.column, r) += equations[row.equation][term.coefficient] * term.factor;
    }
    const Eigen::PartialPivLU<Eigen::Ref<Matrix<Scalar>>> lu(transposed);
    const auto chosen = lu.matrixLU().topLeftCorner(rows, rows);
    const auto others = lu.matrixLU().bottomLeftCorner(rest, rows);
    Matrix<Scalar> basis(columns, rest);
    basis.topRows(rows) =
        -chosen.template triangularView<Eigen::UnitLower>().transpose().solve(others.transpose());
    basis.bottomRows(rest).setIdentity();
    return lu.permutationP().transpose() * basis;
}

/// A function of the rotation times each monomial of lower degree, as combinations of the rows of
/// the basis. The function has these coefficients.
template <class Scalar>
RegistrationTemplate::Matrix<Scalar>
RegistrationTemplate::product_values(const std::vector<double>& function,
                                     const Matrix<Scalar>& basis) const {
    Matrix<Scalar> result =
        Matrix<Scalar>::Zero(static_cast<Eigen::Index>(products_.size()), basis.cols());
    for (Eigen::Index k = 0; k < result.rows(); ++k)
        for (std::size_t i = 0; i < function.size(); ++i)
            for (const Term& term : products_[static_cast<std::size_t>(k)][i])
                result.row(k) += function[i] * term.factor * basis.row(term.column);
    return result;
}

template <class Scalar>
std::vector<Matrix3cd> RegistrationTemplate::solve(const KnownScene<Scalar>& scene) const {
    const Matrix<Scalar> basis = null_space<Scalar>(scene);
    const Matrix<Scalar> action =
        quotient<Scalar>(product_values(h_, basis), product_values(g_, basis));
    if (!action.allFinite()) return {};
    const auto found = eigensystem<Scalar>(action);
    if (!found) return {};
    const MatrixXcd values = basis.template cast<Complex>() * found->vectors;
    std::vector<Matrix3cd> rotations;
    for (Eigen::Index k = 0; k < values.cols(); ++k) {
        const bool second_of_pair = std::is_same_v<Scalar, double> && found->values[k].imag() < 0;
        if (second_of_pair) continue;
        const Matrix3cd R = rotation(values.col(k));
        if (R.allFinite()) rotations.push_back(R);
    }
    return rotations;
}

/// From the values of the monomials, up to a common factor. Where the rotation has large entries,
/// the values of low degree are lost in rounding errors; so those of the unit monomials are read
/// off their products with the monomial that has the largest value.
Matrix3cd RegistrationTemplate::rotation(const Eigen::VectorXcd& values) const {
    const auto value_of = [&](const Terms& product) {
        Complex sum = 0;
        for (const Term& term : product)
            sum += term.factor * values[term.column];
        return sum;
    };
    const auto& products = *std::ranges::max_element(
        products_, {}, [&](const auto& of_one) { return std::abs(value_of(of_one.front())); });
    Eigen::VectorXcd units(static_cast<Eigen::Index>(products.size()));
    for (Eigen::Index i = 0; i < units.size(); ++i)
        units[i] = value_of(products[static_cast<std::size_t>(i)]);
    if (frame_ != Frame::general)
        return rotation_of<Complex>(frame_, units.segment<4>(1) / units[0]);
    // The products of the coordinates of the quaternion: w x, w y, w z, x x, ..., z z.
    Eigen::Matrix4cd squares;
    Eigen::Index next = 1;
    for (Eigen::Index i = 0; i < 4; ++i)
        for (Eigen::Index j = std::max<Eigen::Index>(i, 1); j < 4; ++j)
            squares(i, j) = squares(j, i) = units[next++];
    squares(0, 0) = units[0] - squares(1, 1) - squares(2, 2) - squares(3, 3);
    Eigen::Index largest = 0;
    squares.diagonal().cwiseAbs().maxCoeff(&largest);
    return rotation_of<Complex>(frame_, squares.col(largest));
}

std::vector<Matrix3cd> RegistrationTemplate::rotations(const KnownScene<Complex>& scene) const {
    bool is_real = true;
    const auto note = [&](const Eigen::Vector3cd& x) {
        is_real = is_real && x.imag().isZero(0);
        return x;
    };
    mapped<Complex>(scene, note, note, note);
    if (!is_real) return solve<Complex>(scene);
    const auto real = [](const Eigen::Vector3cd& x) -> Eigen::Vector3d { return x.real(); };
    return solve<double>(mapped<double>(scene, real, real, real));
}

} // namespace plprove
