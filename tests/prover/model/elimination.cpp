// The elimination of sparse matrices in the tracker of models, against Eigen.
#include "prover/model/solver/elimination_order.h"
#include "prover/model/solver/tracking/sparse_elimination.h"
#include "prover/three_views/random.h"

#include <Eigen/LU>
#include <doctest/doctest.h>
#include <set>

namespace {

using namespace plprove;
using namespace plprove::model;

/// A random regular matrix with a column to its right: of the coefficients, `dense` of 16 are not
/// 0, beside one of each row and column.
Eigen::MatrixXcd sparse_matrix(Eigen::Index size, std::uint64_t dense, Random& random) {
    Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Zero(size, size + 1);
    for (Eigen::Index i = 0; i < size; ++i) {
        for (Eigen::Index j = 0; j < size; ++j)
            if (j == (i * 5 + 3) % size || random.bits() % 16 < dense)
                matrix(i, j) = random.complex();
        matrix(i, size) = random.complex();
    }
    return matrix;
}

EliminationOrder order_for(const Eigen::MatrixXcd& matrix) {
    std::vector<std::vector<bool>> nonzero;
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        nonzero.emplace_back();
        for (Eigen::Index j = 0; j < matrix.rows(); ++j)
            nonzero.back().push_back(matrix(i, j) != 0.0);
    }
    return elimination_order(std::move(nonzero));
}

/// What the matrix times x is the last column, times -1.
Eigen::VectorXcd solved(const Eigen::MatrixXcd& matrix, const EliminationOrder& order) {
    namespace lanes = model::portable;
    const Eigen::Index n = matrix.rows();
    TrackedProgram program;
    program.unknowns = static_cast<int>(n);
    program.step = order.steps.data();
    program.index = order.indices.data();
    std::vector<lanes::Number> entries, inverse(static_cast<std::size_t>(n)), x(inverse.size());
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j <= n; ++j)
            entries.push_back({{matrix(i, j).real()}, {matrix(i, j).imag()}});
    lanes::SparseElimination elimination(
        program, {entries.data(), program.unknowns, program.unknowns + 1}, inverse.data());
    elimination.eliminate();
    elimination.substitute(program.unknowns, x.data());
    Eigen::VectorXcd result(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const lanes::Number& number = x[static_cast<std::size_t>(i)];
        result[i] = {number.re.v, number.im.v};
    }
    return result;
}

} // namespace

TEST_CASE("sparse equations are solved as Eigen solves them") {
    Random random(3, 0);
    for (const std::uint64_t dense : {0, 1, 3, 8, 16})
        for (const Eigen::Index size : {1, 2, 7, 16, 33}) {
            const Eigen::MatrixXcd matrix = sparse_matrix(size, dense, random);
            const Eigen::VectorXcd expected =
                matrix.leftCols(size).partialPivLu().solve(-matrix.col(size));
            CHECK((solved(matrix, order_for(matrix)) - expected).norm() < 1e-8 * expected.norm());
        }
}

TEST_CASE("each unknown is eliminated once, where few coefficients change first") {
    // Unknowns 0 and 1 are in all equations, each other one in two of them.
    constexpr std::size_t size = 12;
    std::vector<std::vector<bool>> nonzero(size, std::vector<bool>(size));
    for (std::size_t row = 0; row < size; ++row) {
        nonzero[row][0] = nonzero[row][1] = true;
        nonzero[row][2 + row % (size - 2)] = nonzero[row][2 + (row + 1) % (size - 2)] = true;
    }
    const EliminationOrder order = elimination_order(nonzero);
    std::set<int> columns, pivots;
    std::size_t products = 0;
    for (const EliminationStep& step : order.steps) {
        columns.insert(step.column);
        pivots.insert(order.indices[static_cast<std::size_t>(step.rows)]);
        products +=
            static_cast<std::size_t>((step.columns - step.rows) * (step.end - step.columns));
    }
    CHECK(columns.size() == size);
    CHECK(pivots.size() == size);
    CHECK(columns.contains(order.steps[0].column));
    CHECK(order.steps[0].column > 1);
    CHECK(products < size * size * size / 6); // half of what dense equations take
}

TEST_CASE("of a singular matrix each row has a pivot, too") {
    std::vector<std::vector<bool>> nonzero(4, {true, true, false, false});
    std::set<int> columns, pivots;
    const EliminationOrder order = elimination_order(nonzero);
    for (const EliminationStep& step : order.steps) {
        columns.insert(step.column);
        REQUIRE(step.columns > step.rows);
        pivots.insert(order.indices[static_cast<std::size_t>(step.rows)]);
    }
    CHECK(columns == std::set<int>{0, 1, 2, 3});
    CHECK(pivots == std::set<int>{0, 1, 2, 3});
}
