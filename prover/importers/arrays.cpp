#include "prover/importers/arrays.h"

#include <algorithm>

namespace plprove::importers {

namespace {

using model::ModelError;
using model::Position;

constexpr std::size_t most_entries = 4000, longest_array = std::size_t{1} << 22U;

[[noreturn]] void refuse(Position at, const std::string& what, const Array& a, const Array& b) {
    throw ModelError(at, "found " + description(a) + " and " + description(b) + ": " + what);
}

/// The operation on integers if both are, and its result is a constant of models.
template <class OnIntegers>
Value computed(const Value& a, const Value& b, Position at, Operation operation,
               const OnIntegers& on_integers) {
    constexpr long largest = 999'999;
    const std::optional<long> m = integer_of(a), n = integer_of(b);
    if (!m || !n) return operation(a, b, at);
    const std::optional<long> result = on_integers(*m, *n);
    return result && std::abs(*result) <= largest ? constant(*result) : operation(a, b, at);
}

std::size_t common_size(std::size_t m, std::size_t n, const Array& a, const Array& b, Position at) {
    if (m != n && m != 1 && n != 1) refuse(at, "their sizes do not fit", a, b);
    return m == 1 ? n : m;
}

std::size_t highest(const Index& index) {
    return index.places.empty() ? 0 : *std::ranges::max_element(index.places) + 1;
}

void refuse_beyond(const Index& index, std::size_t size, const Array& array, Position at) {
    if (highest(index) > size)
        throw ModelError(at, "found the index " + std::to_string(highest(index)) + " of " +
                                 description(array));
}

void grow(Array& array, std::size_t rows, std::size_t columns, Position at) {
    rows = std::max(rows, array.rows);
    columns = std::max(columns, array.columns);
    if (rows == array.rows && columns == array.columns) return;
    refuse_large(rows, columns, at);
    Array larger = Array::filled(rows, columns, constant(0));
    for (std::size_t j = 0; j < array.columns; ++j)
        for (std::size_t i = 0; i < array.rows; ++i)
            larger.entry(i, j) = array.entry(i, j);
    array = std::move(larger);
}

} // namespace

Value constant(long integer) {
    return integer < 0 ? Value::scalar(std::to_string(integer), Value::Level::sum)
                       : Value::scalar(std::to_string(integer));
}

std::optional<long> integer_of(const Value& value) {
    constexpr std::size_t longest = 7;
    const std::string& text = value.text;
    const std::size_t first = text.starts_with('-') ? 1 : 0;
    if (text.size() == first || text.size() > longest ||
        text.find_first_not_of("0123456789", first) != std::string::npos)
        return std::nullopt;
    return std::stol(text);
}

std::string description(const Array& array) {
    if (array.is_scalar()) return "a scalar";
    return "a " + std::to_string(array.rows) + " by " + std::to_string(array.columns) + " array";
}

void refuse_large(std::size_t rows, std::size_t columns, Position at) {
    if (rows > most_entries || columns > most_entries || rows * columns > most_entries)
        throw ModelError(at, "an array to import has at most 4000 entries");
}

void refuse_large(const Array& array, Position at) {
    refuse_large(array.rows, array.columns, at);
    std::size_t length = 0;
    for (const Value& entry : array.entries)
        length += entry.text.size();
    if (length > longest_array)
        throw ModelError(at, "this is too long for a model: state a smaller problem");
}

Value sum_of(const Value& a, const Value& b, Position at) {
    return computed(a, b, at, sum, [](long m, long n) { return std::optional(m + n); });
}

Value difference_of(const Value& a, const Value& b, Position at) {
    return computed(a, b, at, difference, [](long m, long n) { return std::optional(m - n); });
}

Value product_of(const Value& a, const Value& b, Position at) {
    return computed(a, b, at, product, [](long m, long n) { return std::optional(m * n); });
}

Value quotient_of(const Value& a, const Value& b, Position at) {
    return computed(a, b, at, quotient, [](long m, long n) {
        return n != 0 && m % n == 0 ? std::optional(m / n) : std::nullopt;
    });
}

Value power_of(const Value& a, const Value& exponent, Position at) {
    constexpr long most = 100;
    const std::optional<long> n = integer_of(exponent);
    if (!n || *n < 0 || *n > most)
        throw ModelError(at, "an exponent is a whole number from 0 to 100");
    if (!integer_of(a)) return power(a, static_cast<int>(*n), at);
    Value result = constant(1);
    for (long i = 0; i < *n; ++i)
        result = product_of(result, a, at);
    return result;
}

Array entrywise(const Array& a, const Array& b, Position at, Operation operation) {
    const std::size_t rows = common_size(a.rows, b.rows, a, b, at);
    const std::size_t columns = common_size(a.columns, b.columns, a, b, at);
    refuse_large(rows, columns, at);
    Array result{rows, columns, {}};
    const auto entry = [](const Array& of, std::size_t i, std::size_t j) -> const Value& {
        return of.entry(of.rows == 1 ? 0 : i, of.columns == 1 ? 0 : j);
    };
    for (std::size_t j = 0; j < columns; ++j)
        for (std::size_t i = 0; i < rows; ++i)
            result.entries.push_back(operation(entry(a, i, j), entry(b, i, j), at));
    refuse_large(result, at);
    return result;
}

Array matrix_product(const Array& a, const Array& b, Position at) {
    if (a.is_scalar() || b.is_scalar()) return entrywise(a, b, at, product_of);
    if (a.columns != b.rows) refuse(at, "their product is not defined", a, b);
    refuse_large(a.rows, b.columns, at);
    Array result = Array::filled(a.rows, b.columns, constant(0));
    for (std::size_t j = 0; j < b.columns; ++j)
        for (std::size_t i = 0; i < a.rows; ++i)
            for (std::size_t k = 0; k < a.columns; ++k)
                result.entry(i, j) =
                    sum_of(result.entry(i, j), product_of(a.entry(i, k), b.entry(k, j), at), at);
    refuse_large(result, at);
    return result;
}

Array matrix_power(const Array& a, const Array& exponent, Position at) {
    if (a.is_scalar() && exponent.is_scalar()) return entrywise(a, exponent, at, power_of);
    constexpr long most = 10;
    const std::optional<long> n =
        exponent.is_scalar() ? integer_of(exponent.entries[0]) : std::nullopt;
    if (a.rows != a.columns || !n || *n < 1 || *n > most)
        refuse(at, "a square matrix has powers from 1 to 10", a, exponent);
    Array result = a;
    for (long i = 1; i < *n; ++i)
        result = matrix_product(result, a, at);
    return result;
}

Array transposed(const Array& a) {
    Array result{a.columns, a.rows, {}};
    for (std::size_t i = 0; i < a.rows; ++i)
        for (std::size_t j = 0; j < a.columns; ++j)
            result.entries.push_back(a.entry(i, j));
    return result;
}

Array beside(const std::vector<Array>& parts, Position at) {
    Array result;
    for (const Array& part : parts) {
        if (part.size() == 0) continue;
        if (result.size() == 0) result.rows = part.rows;
        if (part.rows != result.rows) refuse(at, "they do not fit beside each other", result, part);
        result.entries.insert(result.entries.end(), part.entries.begin(), part.entries.end());
        result.columns += part.columns;
    }
    refuse_large(result, at);
    return result;
}

Array below(const std::vector<Array>& parts, Position at) {
    std::vector<Array> sides;
    for (const Array& part : parts) {
        if (part.size() != 0 && !sides.empty() && sides[0].rows != part.columns)
            refuse(at, "they do not fit below each other", transposed(sides[0]), part);
        if (part.size() != 0) sides.push_back(transposed(part));
    }
    return transposed(beside(sides, at));
}

Array part(const Array& array, const std::vector<Index>& at_indices, Position at) {
    const Index& first = at_indices.front();
    Array result;
    if (at_indices.size() == 1) {
        refuse_beyond(first, array.size(), array, at);
        const bool along = array.is_vector() && !array.is_scalar() && !first.all &&
                           (first.rows == 1 || first.columns == 1);
        const std::size_t count = first.places.size();
        result.rows = first.all ? count : along ? (array.rows == 1 ? 1 : count) : first.rows;
        result.columns = first.all ? 1 : along ? (array.rows == 1 ? count : 1) : first.columns;
        for (const std::size_t place : first.places)
            result.entries.push_back(array.entries[place]);
        refuse_large(result, at);
        return result;
    }
    const Index& second = at_indices[1];
    refuse_beyond(first, array.rows, array, at);
    refuse_beyond(second, array.columns, array, at);
    refuse_large(first.places.size(), second.places.size(), at);
    result = {first.places.size(), second.places.size(), {}};
    for (const std::size_t j : second.places)
        for (const std::size_t i : first.places)
            result.entries.push_back(array.entry(i, j));
    refuse_large(result, at);
    return result;
}

void assign(Array& array, const std::vector<Index>& at_indices, const Array& value, Position at) {
    const Index& first = at_indices.front();
    const std::size_t count =
        first.places.size() * (at_indices.size() == 1 ? 1 : at_indices[1].places.size());
    if (!value.is_scalar() && value.size() != count)
        throw ModelError(at, "found " + description(value) + " for " + std::to_string(count) +
                                 " entries of an array");
    const auto entry = [&](std::size_t k) { return value.entries[value.is_scalar() ? 0 : k]; };
    if (at_indices.size() == 1) {
        if (highest(first) > array.size()) {
            if (array.size() != 0 && !array.is_vector())
                refuse_beyond(first, array.size(), array, at);
            const bool is_column = array.columns == 1 && array.rows > 1;
            grow(array, is_column ? highest(first) : 1, is_column ? 1 : highest(first), at);
        }
        for (std::size_t k = 0; k < count; ++k)
            array.entries[first.places[k]] = entry(k);
    } else {
        const Index& second = at_indices[1];
        grow(array, highest(first), highest(second), at);
        for (std::size_t k = 0; k < count; ++k)
            array.entry(first.places[k % first.places.size()],
                        second.places[k / first.places.size()]) = entry(k);
    }
    refuse_large(array, at);
}

std::size_t size_of(const Value& value, Position at) {
    const std::optional<long> size = integer_of(value);
    if (!size || *size < 0) throw ModelError(at, "a size of an array is a whole number");
    return static_cast<std::size_t>(*size);
}

Sizes sizes_of(const std::vector<Array>& arguments, std::size_t first, Position at) {
    std::vector<Value> given;
    for (std::size_t i = first; i < arguments.size(); ++i)
        given.insert(given.end(), arguments[i].entries.begin(), arguments[i].entries.end());
    if (given.empty()) return {};
    if (given.size() > 2) throw ModelError(at, "an array has two sizes");
    const Sizes sizes{size_of(given.front(), at), size_of(given.back(), at)};
    refuse_large(sizes.rows, sizes.columns, at);
    return sizes;
}

Value as_matrix(const Array& array) {
    std::vector<Value> rows;
    for (std::size_t i = 0; i < array.rows; ++i) {
        std::vector<Value> row;
        for (std::size_t j = 0; j < array.columns; ++j)
            row.push_back(array.entry(i, j));
        rows.push_back(Value::list(std::move(row)));
    }
    return Value::list(std::move(rows));
}

} // namespace plprove::importers
