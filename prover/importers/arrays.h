// The arrays of Matlab: scalars, vectors and matrices in one, with two sizes always.
#pragma once

#include "prover/importers/value.h"

#include <optional>
#include <string>
#include <vector>

namespace plprove::importers {

struct Array {
    std::size_t rows = 0, columns = 0;
    std::vector<Value> entries; ///< scalars, column by column

    static Array scalar(Value value) { return {1, 1, {std::move(value)}}; }
    static Array filled(std::size_t rows, std::size_t columns, const Value& value) {
        return {rows, columns, std::vector<Value>(rows * columns, value)};
    }

    std::size_t size() const { return entries.size(); }
    bool is_scalar() const { return rows == 1 && columns == 1; }
    bool is_vector() const { return rows == 1 || columns == 1; }
    const Value& entry(std::size_t i, std::size_t j) const { return entries[i + j * rows]; }
    Value& entry(std::size_t i, std::size_t j) { return entries[i + j * rows]; }
};

/// Places in one dimension of an array, or among all entries; they count from 0.
struct Index {
    std::vector<std::size_t> places;
    std::size_t rows = 0, columns = 0; ///< the sizes of the array that says the places
    bool all = false;                  ///< a colon
};

/// The text of a small integer; the integer that a scalar is, if it is one.
Value constant(long integer);
std::optional<long> integer_of(const Value& value);

/// "a scalar", "a 3 by 4 array".
std::string description(const Array& array);

/// Refuses what would be larger than any model: more than 4000 entries, or 4 MB of text.
void refuse_large(const Array& array, model::Position at);
void refuse_large(std::size_t rows, std::size_t columns, model::Position at);

// All throw ModelError that names the place if the sizes do not fit. Integers are computed.

using Operation = Value (*)(const Value&, const Value&, model::Position);
Value sum_of(const Value& a, const Value& b, model::Position at);
Value difference_of(const Value& a, const Value& b, model::Position at);
Value product_of(const Value& a, const Value& b, model::Position at);
Value quotient_of(const Value& a, const Value& b, model::Position at);
Value power_of(const Value& a, const Value& exponent, model::Position at);

/// Entry by entry; a scalar, a row or a column is repeated as often as the other array needs.
Array entrywise(const Array& a, const Array& b, model::Position at, Operation operation);
/// The product of matrices, or with a scalar.
Array matrix_product(const Array& a, const Array& b, model::Position at);
Array matrix_power(const Array& a, const Array& exponent, model::Position at);
Array transposed(const Array& a);
/// Beside each other, or below; arrays without entries are left out.
Array beside(const std::vector<Array>& parts, model::Position at);
Array below(const std::vector<Array>& parts, model::Position at);

/// The part at one index, or at a row and a column index.
Array part(const Array& array, const std::vector<Index>& at_indices, model::Position at);
/// Puts the value there; the array grows as it needs, with zeros.
void assign(Array& array, const std::vector<Index>& at_indices, const Array& value,
            model::Position at);

/// The size that a value is; throws ModelError if it is none.
std::size_t size_of(const Value& value, model::Position at);

struct Sizes {
    std::size_t rows = 1, columns = 1;
};
/// The sizes that arguments from `first` on say: (r, c), ([r c]), or (n), which is n by n; 1 by 1
/// if there are none.
Sizes sizes_of(const std::vector<Array>& arguments, std::size_t first, model::Position at);

/// As a list of rows.
Value as_matrix(const Array& array);

} // namespace plprove::importers
