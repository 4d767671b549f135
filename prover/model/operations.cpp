#include "prover/model/operations.h"

#include <algorithm>
#include <bit>
#include <optional>

namespace plprove::model {

namespace {

using Kind = Operation::Kind;

/// More operations than this are no model that can be solved.
constexpr std::size_t most_operations = 5'000'000;

bool is_scalar(const Array& array) {
    return array.shape.empty();
}

bool is_vector(const Array& array) {
    return array.shape.size() == 1;
}

bool is_matrix(const Array& array) {
    return array.shape.size() == 2;
}

Array scalar(ScalarIndex index) {
    return {{}, {index}};
}

std::size_t entry(const Array& matrix, int row, int column) {
    return static_cast<std::size_t>(row * matrix.shape[1] + column);
}

} // namespace

std::string describe_shape(const std::vector<int>& shape) {
    if (shape.empty()) return "a scalar";
    if (shape.size() == 1) return "a vector of " + std::to_string(shape[0]);
    std::string sizes = std::to_string(shape[0]);
    for (std::size_t i = 1; i < shape.size(); ++i)
        sizes += " by " + std::to_string(shape[i]);
    return shape.size() == 2 ? "a " + sizes + " matrix" : "an array of " + sizes;
}

void Operations::fail(const std::string& message) const {
    throw ModelError(at_, message);
}

ScalarIndex Operations::constant(int value) {
    const auto [place, is_new] = constants_.try_emplace(value, program_->operations.size());
    if (is_new)
        program_->operations.push_back(
            {Kind::constant, false, static_cast<std::size_t>(value), 0, 0, false});
    return place->second;
}

ScalarIndex Operations::zero() {
    constexpr int key_of_zero = -1;
    const auto [place, is_new] = constants_.try_emplace(key_of_zero, program_->operations.size());
    if (is_new) program_->operations.push_back({Kind::zero, false, 0, 0, 0, false});
    return place->second;
}

ScalarIndex Operations::add(Kind kind, ScalarIndex left, ScalarIndex right, Position at) {
    auto& all = program_->operations;
    if (all.size() >= most_operations)
        throw ModelError(at,
                         "the model has more than 5,000,000 operations: state a smaller problem");
    all.push_back(
        {kind, all[left].varies || all[right].varies, left, right, divisions_, all[right].varies});
    return all.size() - 1;
}

Array Operations::sum(Kind kind, const Array& left, const Array& right, Position at) {
    at_ = at;
    require(left.shape == right.shape, "found " + describe_shape(left.shape) + " and " +
                                           describe_shape(right.shape) +
                                           ": + and - need equal shapes");
    Array result{left.shape, {}};
    for (std::size_t i = 0; i < left.scalars.size(); ++i)
        result.scalars.push_back(add(kind, left.scalars[i], right.scalars[i], at));
    return result;
}

Array Operations::negative(const Array& array, Position at) {
    Array result{array.shape, {}};
    for (const ScalarIndex scalar : array.scalars)
        result.scalars.push_back(add(Kind::difference, zero(), scalar, at));
    return result;
}

Array Operations::product(const Array& left, const Array& right, Position at) {
    at_ = at;
    const bool by_left = is_scalar(left);
    if (!by_left && !is_scalar(right)) return matrix_product(left, right);
    const Array& array = by_left ? right : left;
    Array result{array.shape, {}};
    for (const ScalarIndex item : array.scalars)
        result.scalars.push_back(by_left ? times(left.scalars[0], item)
                                         : times(item, right.scalars[0]));
    return result;
}

Array Operations::matrix_product(const Array& left, const Array& right) {
    const bool fits = is_matrix(left) && (is_vector(right) || is_matrix(right)) &&
                      left.shape[1] == right.shape[0];
    require(fits, "found " + describe_shape(left.shape) + " times " + describe_shape(right.shape) +
                      ": * needs a scalar, or a matrix and a vector or matrix that fit; dot and "
                      "cross multiply vectors");
    const int columns = is_vector(right) ? 1 : right.shape[1];
    Array result{{left.shape[0]}, {}};
    if (is_matrix(right)) result.shape.push_back(columns);
    for (int row = 0; row < left.shape[0]; ++row)
        for (int column = 0; column < columns; ++column) {
            Scalars u, v;
            for (int k = 0; k < left.shape[1]; ++k) {
                u.push_back(left.scalars[entry(left, row, k)]);
                v.push_back(right.scalars[static_cast<std::size_t>(k * columns + column)]);
            }
            result.scalars.push_back(dot(u, v));
        }
    return result;
}

Array Operations::quotient(const Array& left, const Array& right, Position at) {
    at_ = at;
    require(is_scalar(right),
            "found " + describe_shape(right.shape) + " to the right of /: divide by a scalar");
    ++divisions_;
    Array result{left.shape, {}};
    for (const ScalarIndex item : left.scalars)
        result.scalars.push_back(add(Kind::quotient, item, right.scalars[0], at));
    return result;
}

Array Operations::power(const Array& base, int exponent, Position at) {
    at_ = at;
    require(is_scalar(base),
            "found " + describe_shape(base.shape) + " to the left of ^: only scalars have powers");
    ScalarIndex result = base.scalars[0];
    for (int i = 1; i < exponent; ++i)
        result = times(result, base.scalars[0]);
    return scalar(result);
}

ScalarIndex Operations::dot(const Scalars& u, const Scalars& v) {
    ScalarIndex result = times(u[0], v[0]);
    for (std::size_t i = 1; i < u.size(); ++i)
        result = plus(result, times(u[i], v[i]));
    return result;
}

Array Operations::call(const std::string& name, const std::vector<Array>& arguments, Position at) {
    at_ = at;
    const std::size_t needed = name == "dot" || name == "cross" ? 2 : 1;
    require(arguments.size() == needed, name + " takes " + std::to_string(needed) +
                                            (needed == 1 ? " value" : " values") + ", found " +
                                            std::to_string(arguments.size()));
    if (name == "dot") return dot(arguments);
    if (name == "norm2") return dot({arguments[0], arguments[0]});
    if (name == "cross") return cross(arguments);
    if (name == "skew") return skew(arguments);
    if (name == "trace") return trace(arguments);
    if (name == "transpose") return transpose(arguments);
    if (name == "rotation") return rotation(arguments);
    constexpr int largest = 6;
    const Array& matrix = arguments[0];
    require(is_matrix(matrix) && matrix.shape[0] == matrix.shape[1] && matrix.shape[0] <= largest,
            "found det of " + describe_shape(matrix.shape) +
                ": det needs a square matrix of at most 6 rows");
    return scalar(determinant(matrix));
}

Array Operations::dot(const std::vector<Array>& arguments) {
    require(is_vector(arguments[0]) && arguments[0].shape == arguments[1].shape,
            "found " + describe_shape(arguments[0].shape) + " and " +
                describe_shape(arguments[1].shape) + ": dot and norm2 need vectors of one size");
    return scalar(dot(arguments[0].scalars, arguments[1].scalars));
}

Array Operations::cross(const std::vector<Array>& arguments) {
    const std::vector<int> three{3};
    require(arguments[0].shape == three && arguments[1].shape == three,
            "found " + describe_shape(arguments[0].shape) + " and " +
                describe_shape(arguments[1].shape) + ": cross needs vectors of three");
    const Scalars& u = arguments[0].scalars;
    const Scalars& v = arguments[1].scalars;
    Array result{three, {}};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        result.scalars.push_back(minus(times(u[j], v[k]), times(u[k], v[j])));
    }
    return result;
}

Array Operations::skew(const std::vector<Array>& arguments) {
    require(arguments[0].shape == std::vector<int>{3},
            "found " + describe_shape(arguments[0].shape) + ": skew needs a vector of three");
    const Scalars& v = arguments[0].scalars;
    const auto negated = [&](std::size_t i) { return minus(zero(), v[i]); };
    return {{3, 3}, {zero(), negated(2), v[1], v[2], zero(), negated(0), negated(1), v[0], zero()}};
}

Array Operations::trace(const std::vector<Array>& arguments) {
    const Array& matrix = arguments[0];
    require(is_matrix(matrix) && matrix.shape[0] == matrix.shape[1],
            "found " + describe_shape(matrix.shape) + ": trace needs a square matrix");
    ScalarIndex result = matrix.scalars[0];
    for (int i = 1; i < matrix.shape[0]; ++i)
        result = plus(result, matrix.scalars[entry(matrix, i, i)]);
    return scalar(result);
}

Array Operations::transpose(const std::vector<Array>& arguments) {
    const Array& matrix = arguments[0];
    require(is_matrix(matrix),
            "found " + describe_shape(matrix.shape) + ": transpose needs a matrix");
    Array result{{matrix.shape[1], matrix.shape[0]}, {}};
    for (int row = 0; row < matrix.shape[1]; ++row)
        for (int column = 0; column < matrix.shape[0]; ++column)
            result.scalars.push_back(matrix.scalars[entry(matrix, column, row)]);
    return result;
}

Array Operations::identity(int size) {
    Array result{{size, size}, {}};
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column)
            result.scalars.push_back(row == column ? constant(1) : zero());
    return result;
}

/// Expands by the first row, each minor of the last rows once.
ScalarIndex Operations::determinant(const Array& matrix) {
    const int size = matrix.shape[0];
    std::map<std::uint32_t, ScalarIndex> minors; // of the last rows and these columns
    for (int column = 0; column < size; ++column)
        minors[1U << column] = matrix.scalars[entry(matrix, size - 1, column)];
    for (int row = size - 2; row >= 0; --row) {
        std::map<std::uint32_t, ScalarIndex> larger;
        for (std::uint32_t set = 0; set < (1U << size); ++set) {
            if (std::popcount(set) != size - row) continue;
            std::optional<ScalarIndex> result;
            bool positive = true;
            for (int column = 0; column < size; ++column) {
                if ((set >> column & 1U) == 0) continue;
                const ScalarIndex term = times(matrix.scalars[entry(matrix, row, column)],
                                               minors.at(set & ~(1U << column)));
                if (!result)
                    result = term;
                else
                    result = positive ? plus(*result, term) : minus(*result, term);
                positive = !positive;
            }
            larger[set] = *result;
        }
        minors = std::move(larger);
    }
    return minors.at((1U << size) - 1);
}

/// The matrix of certs/FORMAT.md, section 2.
Array Operations::rotation(const std::vector<Array>& arguments) {
    const Array& given = arguments[0];
    require(
        is_vector(given) && (given.shape[0] == 3 || given.shape[0] == 4),
        "found " + describe_shape(given.shape) +
            ": rotation needs a quaternion, a vector of four, or a vector (1, q) without its 1");
    Scalars q = given.scalars;
    if (q.size() == 3) q.insert(q.begin(), constant(1));
    const ScalarIndex two = constant(2);
    const auto square = [&](std::size_t i) { return times(q[i], q[i]); };
    const auto twice = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l,
                           bool add_them) {
        const ScalarIndex x = times(q[i], q[j]), y = times(q[k], q[l]);
        return times(two, add_them ? plus(x, y) : minus(x, y));
    };
    const auto diagonal = [&](std::size_t i) {
        ScalarIndex result = square(0);
        for (std::size_t k = 1; k < 4; ++k)
            result = k == i ? plus(result, square(k)) : minus(result, square(k));
        return result;
    };
    program_->conditions.push_back({dot(q, q), at_});
    return {{3, 3},
            {diagonal(1), twice(1, 2, 0, 3, false), twice(1, 3, 0, 2, true),
             twice(1, 2, 0, 3, true), diagonal(2), twice(2, 3, 0, 1, false),
             twice(1, 3, 0, 2, false), twice(2, 3, 0, 1, true), diagonal(3)}};
}

} // namespace plprove::model
