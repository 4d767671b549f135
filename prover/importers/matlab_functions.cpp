#include "prover/importers/matlab_functions.h"

#include <algorithm>
#include <map>

namespace plprove::importers {

namespace {

using model::ModelError;
using model::Position;

struct Call {
    const std::vector<Array>& arguments;
    Draft& draft;
    Position at;

    const Array& first() const { return arguments.front(); }
};

Array filled(const Call& call, long value) {
    const Sizes sizes = sizes_of(call.arguments, 0, call.at);
    return Array::filled(sizes.rows, sizes.columns, constant(value));
}

Array eye(const Call& call) {
    Array result = filled(call, 0);
    for (std::size_t i = 0; i < std::min(result.rows, result.columns); ++i)
        result.entry(i, i) = constant(1);
    return result;
}

/// Its minors get names as they come, lest the text grows with each of them.
Array det(const Call& call) {
    const auto with_names = [&](const Value& value) { return call.draft.named("t", value); };
    return Array::scalar(with_names(determinant(with_names(as_matrix(call.first())), call.at)));
}

Array diagonal(const Array& matrix) {
    Array result{std::min(matrix.rows, matrix.columns), 1, {}};
    for (std::size_t i = 0; i < result.rows; ++i)
        result.entries.push_back(matrix.entry(i, i));
    return result;
}

Array diag(const Call& call) {
    const Array& array = call.first();
    if (!array.is_vector()) return diagonal(array);
    refuse_large(array.size(), array.size(), call.at);
    Array result = Array::filled(array.size(), array.size(), constant(0));
    for (std::size_t i = 0; i < array.size(); ++i)
        result.entry(i, i) = array.entries[i];
    return result;
}

/// Of each column; of a vector, of all entries; of each row if the second argument is 2.
Array sum_along(const Array& array, bool rows, Position at) {
    if (rows) return transposed(sum_along(transposed(array), false, at));
    Array result = Array::filled(1, array.columns, constant(0));
    for (std::size_t j = 0; j < array.columns; ++j)
        for (std::size_t i = 0; i < array.rows; ++i)
            result.entries[j] = sum_of(result.entries[j], array.entry(i, j), at);
    refuse_large(result, at);
    return result;
}

Array total(const Call& call) {
    const bool rows = call.arguments.size() > 1
                          ? call.arguments[1].size() == 1 && call.arguments[1].entries[0].is("2")
                          : call.first().rows == 1;
    return sum_along(call.first(), rows, call.at);
}

Array trace(const Call& call) {
    if (call.first().rows != call.first().columns)
        throw ModelError(call.at, "found the trace of " + description(call.first()));
    return sum_along(diagonal(call.first()), false, call.at);
}

Array reshape(const Call& call) {
    const Array& array = call.first();
    Array result = array;
    if (call.arguments.size() == 3 && call.arguments[1].size() + call.arguments[2].size() == 1) {
        const bool rows = call.arguments[1].size() == 1; // reshape(a, 3, []) or reshape(a, [], 3)
        const std::size_t size = size_of(call.arguments[rows ? 1 : 2].entries[0], call.at);
        const std::size_t other = size == 0 ? 0 : array.size() / size;
        result.rows = rows ? size : other;
        result.columns = rows ? other : size;
    } else {
        const Sizes sizes = sizes_of(call.arguments, 1, call.at);
        result.rows = sizes.rows;
        result.columns = sizes.columns;
    }
    if (result.rows * result.columns != array.size())
        throw ModelError(call.at, "found " + description(array) + " for an array of " +
                                      std::to_string(result.rows) + " by " +
                                      std::to_string(result.columns));
    return result;
}

Array size(const Call& call) {
    const Array both{1,
                     2,
                     {constant(static_cast<long>(call.first().rows)),
                      constant(static_cast<long>(call.first().columns))}};
    if (call.arguments.size() < 2) return both;
    const std::size_t which =
        call.arguments[1].size() == 1 ? size_of(call.arguments[1].entries[0], call.at) : 0;
    if (which != 1 && which != 2) throw ModelError(call.at, "an array has the sizes 1 and 2");
    return Array::scalar(both.entries[which - 1]);
}

Array length(const Call& call) {
    const Array& array = call.first();
    return Array::scalar(
        constant(array.size() == 0 ? 0 : static_cast<long>(std::max(array.rows, array.columns))));
}

Array count(const Call& call) {
    return Array::scalar(constant(static_cast<long>(call.first().size())));
}

Array dot_product(const Call& call) {
    return Array::scalar(
        dot(Value::list(call.first().entries), Value::list(call.arguments[1].entries), call.at));
}

Array cross_product(const Call& call) {
    Array result = call.first();
    result.entries =
        cross(Value::list(call.first().entries), Value::list(call.arguments[1].entries), call.at)
            .items;
    return result;
}

/// The matrix of the cross product with a vector.
Array skew(const Call& call) {
    constexpr std::size_t size = 3;
    const std::vector<Value>& v = call.first().entries;
    if (v.size() != size)
        throw ModelError(call.at, "found skew of " + description(call.first()) + ": it needs 3");
    const auto minus = [&](std::size_t i) { return negative(v[i], call.at); };
    const Value zero = constant(0);
    return {size, size, {zero, v[2], minus(1), minus(2), zero, v[0], v[1], minus(0), zero}};
}

struct Function {
    std::size_t fewest, most; ///< arguments
    Array (*value)(const Call& call);
};

const std::map<std::string, Function>& functions() {
    static const auto same = [](const Call& call) { return call.first(); };
    static const std::map<std::string, Function> table{
        {"zeros", {0, 2, [](const Call& call) { return filled(call, 0); }}},
        {"ones", {0, 2, [](const Call& call) { return filled(call, 1); }}},
        {"eye", {0, 2, eye}},
        {"multipol", {0, 0, [](const Call& call) { return filled(call, 0); }}},
        {"true", {0, 0, [](const Call& call) { return filled(call, 1); }}},
        {"false", {0, 0, [](const Call& call) { return filled(call, 0); }}},
        {"nargin", {0, 0, [](const Call& call) { return filled(call, 0); }}},
        {"nargout", {0, 0, [](const Call& call) { return filled(call, 1); }}},
        {"det", {1, 1, det}},
        {"diag", {1, 1, diag}},
        {"trace", {1, 1, trace}},
        {"transpose", {1, 1, [](const Call& call) { return transposed(call.first()); }}},
        {"dot", {2, 2, dot_product}},
        {"cross", {2, 2, cross_product}},
        {"skew", {1, 1, skew}},
        {"sum", {1, 2, total}},
        {"reshape", {2, 3, reshape}},
        {"size", {1, 2, size}},
        {"length", {1, 1, length}},
        {"numel", {1, 1, count}},
        {"expand", {1, 1, same}},
        {"simplify", {1, 1, same}},
        {"collect", {1, 1, same}},
        {"sym", {1, 1, same}},
    };
    return table;
}

} // namespace

bool is_matlab_function(const std::string& name) {
    return functions().contains(name);
}

Array matlab_function(const std::string& name, const std::vector<Array>& arguments, Draft& draft,
                      Position at) {
    const Function& function = functions().at(name);
    if (arguments.size() < function.fewest || arguments.size() > function.most)
        throw ModelError(
            at,
            "found '" + name + "' of " + std::to_string(arguments.size()) + " values: it needs " +
                std::to_string(function.fewest) +
                (function.most == function.fewest ? "" : " to " + std::to_string(function.most)));
    return function.value({arguments, draft, at});
}

} // namespace plprove::importers
