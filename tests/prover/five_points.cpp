// The five-point problem: its relative poses by monodromy, its essential matrices by elimination.
#include "prover/degree/five_points.h"

#include "prover/catalogue/degrees.h"
#include "prover/classification/decision.h"
#include "tests/support/solved_class.h"

#include <Eigen/Dense>
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

} // namespace

TEST_CASE("extensions of the five-point problem have 20 relative poses of 10 essential matrices") {
    for (const char* text : {"2*P/P/P + a/a/a + 3*-/P/P", "3*P/P/P + 2*-/P/P",
                             "2*P/P/P + a/P/Pa + 2*-/P/P + P/-/P", "3*a/a/a + 5*-/P/P"}) {
        CAPTURE(text);
        const Solved solved(number_of(text));
        const Subproblems parts = subproblems(solved.system);
        REQUIRE(parts.five_points.size() == 1);
        const PoseCount count = count_poses(parts.five_points.front(), solved.monodromy.chart(),
                                            solved.monodromy.solutions().points());
        CHECK(count.poses == poses_of_five_points);
        CHECK(2 * count.essential_matrices == poses_of_five_points);
    }
}

TEST_CASE("what is solved in place of the five-point problem extends it by a registration") {
    const std::size_t number = five_point_extension();
    const Families known = families(label_classes()[number]);
    CHECK(known.five_point_extension);
    CHECK(known.registration);
    const DegreeRun run = compute_degree(number, {.certificate = false});
    CHECK(run.complete());
    REQUIRE(run.five_point_poses);
    CHECK(run.five_point_poses->poses == poses_of_five_points);
    CHECK(run.degree % poses_of_five_points == 0);
    // No extension on file has fewer solutions.
    for (const ClassDegree& row : degrees_on_file())
        if (families(label_classes()[row.constraint_class]).five_point_extension)
            CHECK(row.degree >= run.degree);
    CHECK_FALSE(compute_degree(number_of("3*P/P/P + a/a/a"), {.certificate = false})
                    .five_point_poses.has_value());
}

TEST_CASE("five pairs of image points have at most ten essential matrices, by elimination") {
    // If ten cubics express the ten monomials of degree 3 by those of lower degree, then 1, x, ...,
    // z^2 span the functions on their zeros: there are at most ten. Monodromy finds as many.
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
    const Problem five_points = parse_problem("5*P/P");
    const std::vector<Problem> kinds{
        parse_problem("P/P"), parse_problem("Pa/Pa"), parse_problem("Pab/Pab"),
        parse_problem("a/a"), parse_problem("Pa/a"),  parse_problem("Pab/Pa"),
        parse_problem("P/-"), parse_problem("a/b"),   parse_problem("Pabc/Pc")};
    int minimal = 0;
    for (int trial = 0; trial < 20'000; ++trial) {
        Problem problem;
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
