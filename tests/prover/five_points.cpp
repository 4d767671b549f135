// The five-point problem: its relative poses by monodromy, its essential matrices by elimination.
#include "prover/problem/five_points.h"

#include "prover/catalogue/degrees.h"
#include "prover/minimal/decision.h"
#include "tests/support/solved_class.h"

#include <Eigen/Dense>
#include <algorithm>
#include <doctest/doctest.h>
#include <map>
#include <random>

using namespace plprove;

namespace {

/// Exponents of x, y, z.
using Monomial = std::array<int, 3>;
using Polynomial = std::map<Monomial, double>;
using PolynomialMatrix = std::array<std::array<Polynomial, 3>, 3>;

Polynomial sum(const Polynomial& a, const Polynomial& b, double factor = 1) {
    Polynomial result = a;
    for (const auto& [monomial, coefficient] : b)
        result[monomial] += factor * coefficient;
    return result;
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
    Polynomial result;
    for (const auto& [m, x] : a)
        for (const auto& [n, y] : b)
            result[{m[0] + n[0], m[1] + n[1], m[2] + n[2]}] += x * y;
    return result;
}

PolynomialMatrix product(const PolynomialMatrix& a, const PolynomialMatrix& b) {
    PolynomialMatrix result;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k)
                result[i][j] = sum(result[i][j], product(a[i][k], b[k][j]));
    return result;
}

PolynomialMatrix transposed(const PolynomialMatrix& a) {
    PolynomialMatrix result;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            result[i][j] = a[j][i];
    return result;
}

Polynomial determinant(const PolynomialMatrix& a) {
    Polynomial result;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const Polynomial minor = sum(product(a[1][j], a[2][k]), product(a[1][k], a[2][j]), -1);
        result = sum(result, product(a[0][i], minor));
    }
    return result;
}

/// The matrices that five random pairs of image points leave: x A + y B + z C + D.
PolynomialMatrix pencil_of_five_pairs(std::mt19937& random) {
    std::normal_distribution<double> normal;
    Eigen::Matrix<double, 5, 9> conditions;
    for (int row = 0; row < 5; ++row) {
        const Eigen::Vector3d first(normal(random), normal(random), 1);
        const Eigen::Vector3d second(normal(random), normal(random), 1);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                conditions(row, 3 * i + j) = second[i] * first[j];
    }
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(conditions);
    const Eigen::MatrixXd kernel = lu.kernel();
    REQUIRE(kernel.cols() == 4);
    const Monomial unknowns[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
    PolynomialMatrix pencil;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 4; ++k)
                pencil[i][j][unknowns[k]] =
                    kernel(static_cast<Eigen::Index>(3 * i + j), static_cast<Eigen::Index>(k));
    return pencil;
}

/// det E = 0 and 2 E E^T E - trace(E E^T) E = 0 (M. Demazure 1988): ten cubics.
std::vector<Polynomial> demazure_equations(const PolynomialMatrix& e) {
    const PolynomialMatrix square = product(e, transposed(e));
    const PolynomialMatrix cube = product(square, e);
    const Polynomial trace = sum(sum(square[0][0], square[1][1]), square[2][2]);
    std::vector<Polynomial> equations{determinant(e)};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            equations.push_back(sum(sum(cube[i][j], cube[i][j]), product(trace, e[i][j]), -1));
    return equations;
}

using Quaternion = std::array<Complex, 4>;

Quaternion quaternion_of(const QuaternionCameras& cameras, int view) {
    if (view == 0) return {1.0, 0.0, 0.0, 0.0};
    return cameras.quaternion[static_cast<std::size_t>(view) - 1];
}

Complex3 centre_of(const QuaternionCameras& cameras, int view) {
    if (view == 0) return {};
    return cameras.centre[static_cast<std::size_t>(view) - 1];
}

/// The rotation from the first view of the pair to the second, as a quaternion with real part 1.
Complex3 relative_rotation(const QuaternionCameras& cameras, const std::array<int, 2>& pair) {
    const auto [a, b, c, d] = quaternion_of(cameras, pair[1]);
    const auto [e, f, g, h] = quaternion_of(cameras, pair[0]);
    const Complex real = a * e + b * f + c * g + d * h;
    return {(b * e - a * f + d * g - c * h) / real, (c * e - a * g + b * h - d * f) / real,
            (d * e - a * h + c * f - b * g) / real};
}

using EssentialMatrix = std::array<Complex, 9>;

/// R_j [c_i - c_j]x R_i^T for the pair i, j, by columns, scaled so that a linear form is 1 on it.
EssentialMatrix essential_matrix(const QuaternionCameras& cameras, const std::array<int, 2>& pair) {
    const Quaternion first = quaternion_of(cameras, pair[0]);
    const Quaternion second = quaternion_of(cameras, pair[1]);
    const Complex3 from = centre_of(cameras, pair[1]);
    Complex3 baseline = centre_of(cameras, pair[0]);
    for (std::size_t k = 0; k < 3; ++k)
        baseline[k] -= from[k];
    EssentialMatrix matrix{};
    Complex form = 0;
    for (std::size_t column = 0; column < 3; ++column) {
        Complex3 axis{};
        axis[column] = 1;
        const Complex3 image = rotate(second, cross(baseline, rotate_back(first, axis)));
        for (std::size_t row = 0; row < 3; ++row) {
            const std::size_t place = 3 * column + row;
            matrix[place] = image[row];
            // A form without meaning, so that it is 0 on no matrix of interest.
            form += std::polar(1.0, 1.0 + 2.3 * static_cast<double>(place)) * image[row];
        }
    }
    for (Complex& entry : matrix)
        entry /= form;
    return matrix;
}

template <std::size_t N>
bool same(const std::array<Complex, N>& a, const std::array<Complex, N>& b) {
    constexpr double tolerance = 1e-5;
    double distance = 0, size = 1;
    for (std::size_t k = 0; k < N; ++k) {
        distance += std::norm(a[k] - b[k]);
        size += std::norm(a[k]);
    }
    return distance < tolerance * tolerance * size;
}

template <class Value>
void add_if_new(std::vector<Value>& values, const Value& value) {
    if (std::ranges::none_of(values, [&](const Value& known) { return same(known, value); }))
        values.push_back(value);
}

/// The pair of views, counted from 0, that share exactly five points.
std::array<int, 2> views_that_share_points(const CameraSystem& system) {
    for (const std::array<int, 2> pair : {std::array{0, 1}, std::array{0, 2}, std::array{1, 2}})
        if (std::ranges::count_if(system.features, [&](const Feature& feature) {
                return feature.sees_point(pair[0]) && feature.sees_point(pair[1]);
            }) == 5)
            return pair;
    throw std::logic_error("no two views share five points");
}

} // namespace

TEST_CASE("extensions of the five-point problem have 20 relative poses of 10 essential matrices") {
    for (const char* text : {"2*P/P/P + a/a/a + 3*-/P/P", "3*P/P/P + 2*-/P/P",
                             "2*P/P/P + a/P/Pa + 2*-/P/P + P/-/P", "3*a/a/a + 5*-/P/P"}) {
        CAPTURE(text);
        const Solved solved(number_of(text));
        const std::array<int, 2> pair = views_that_share_points(solved.system);
        std::vector<Complex3> poses;
        std::vector<EssentialMatrix> matrices;
        for (const CameraPoint& point : solved.solutions()) {
            const QuaternionCameras cameras = solved.loops().chart().cameras(point);
            add_if_new(poses, relative_rotation(cameras, pair));
            add_if_new(matrices, essential_matrix(cameras, pair));
        }
        CHECK(std::ssize(poses) == poses_of_five_points);
        CHECK(2 * std::ssize(matrices) == poses_of_five_points);
    }
}

TEST_CASE("what is solved in place of the five-point problem extends it by a registration") {
    const std::size_t number = five_point_extension();
    const Families known = families(label_classes()[number]);
    CHECK(known.five_point_extension);
    CHECK(known.registration);
    const int degree = degree_on_file(number).value();
    CHECK(degree % poses_of_five_points == 0);
    // No extension on file has fewer solutions.
    for (const ClassDegree& row : degrees_on_file())
        if (families(label_classes()[row.constraint_class]).five_point_extension)
            CHECK(row.degree >= degree);
}

TEST_CASE("five pairs of image points have at most ten essential matrices, by elimination") {
    // If ten cubics express the ten monomials of degree 3 by those of lower degree, then 1, x, ...,
    // z^2 span the functions on their zeros: there are at most ten. Monodromy finds ten.
    std::mt19937 random(7);
    for (int trial = 0; trial < 5; ++trial) {
        const auto equations = demazure_equations(pencil_of_five_pairs(random));
        REQUIRE(equations.size() == 10);
        Eigen::Matrix<double, 10, 10> leading = Eigen::Matrix<double, 10, 10>::Zero();
        for (std::size_t row = 0; row < equations.size(); ++row) {
            Eigen::Index column = 0;
            for (int i = 0; i <= 3; ++i)
                for (int j = 0; i + j <= 3; ++j, ++column)
                    leading(static_cast<Eigen::Index>(row), column) =
                        equations[row].at({i, j, 3 - i - j});
        }
        const Eigen::JacobiSVD<Eigen::MatrixXd> svd(leading);
        CHECK(svd.singularValues()[9] > 1e-9 * svd.singularValues()[0]);
    }
}

TEST_CASE("every minimal problem in two views reduces to five points") {
    std::mt19937 random(3);
    const Features five_points = parse_features("5*P/P");
    const std::vector<Features> kinds{
        parse_features("P/P"), parse_features("Pa/Pa"), parse_features("Pab/Pab"),
        parse_features("a/a"), parse_features("Pa/a"),  parse_features("Pab/Pa"),
        parse_features("P/-"), parse_features("a/b"),   parse_features("Pabc/Pc")};
    int minimal = 0;
    for (int trial = 0; trial < 20'000; ++trial) {
        Features problem;
        for (unsigned left = 4 + random() % 4; left > 0; --left)
            problem.push_back(kinds[random() % kinds.size()].front());
        const Decision decision = decide(problem);
        if (decision.verdict != Verdict::minimal && decision.verdict != Verdict::camera_minimal)
            continue;
        ++minimal;
        CHECK(decision.reduction.reduced == five_points);
    }
    CHECK(minimal > 100);
}
