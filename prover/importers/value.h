// The values of a program that is imported: scalars as texts in the language of models, and lists.
#pragma once

#include "prover/model/words.h"

#include <string>
#include <vector>

namespace plprove::importers {

/// A scalar, or a list; a matrix is a list of rows.
struct Value {
    /// How tightly the text of a scalar binds.
    enum class Level { sum, product, atom };

    bool is_list = false;
    bool is_ideal = false; ///< a list that sums join
    std::string text;
    Level level = Level::atom;
    std::vector<Value> items;

    static Value scalar(std::string text, Level level = Level::atom) {
        return {false, false, std::move(text), level, {}};
    }
    static Value list(std::vector<Value> items) {
        return {true, false, {}, Level::atom, std::move(items)};
    }

    bool is(std::string_view constant) const { return !is_list && text == constant; }
    bool is_matrix() const;
    std::size_t rows() const { return items.size(); }
    std::size_t columns() const { return items.front().items.size(); }
};

/// What a number of any length, with a decimal point or an exponent, is in the language of models,
/// which has integers up to 999,999. Throws ModelError if it has more than 60 digits.
Value number(const std::string& digits, model::Position at);

/// The scalars of a value, in order.
std::vector<Value> scalars(const Value& value);

// All throw ModelError that names the place if the values do not fit.
Value sum(const Value& a, const Value& b, model::Position at);
Value difference(const Value& a, const Value& b, model::Position at);
Value negative(const Value& a, model::Position at);
/// Of scalars, of a scalar and a list, or of matrices; a list to the right of a matrix is a column,
/// and its product with a row is a scalar.
Value product(const Value& a, const Value& b, model::Position at);
Value quotient(const Value& a, const Value& b, model::Position at);
/// Of a scalar or a square matrix, with an exponent from 0 to 100.
Value power(const Value& a, int exponent, model::Position at);
Value transposed(const Value& a, model::Position at);
/// Of at most 6 rows.
Value determinant(const Value& a, model::Position at);
Value dot(const Value& a, const Value& b, model::Position at);
Value cross(const Value& a, const Value& b, model::Position at);

/// "a scalar", "a list of 3", "a 3 by 4 matrix".
std::string description(const Value& value);

} // namespace plprove::importers
