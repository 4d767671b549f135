#include "prover/importers/value.h"

#include <algorithm>

namespace plprove::importers {

namespace {

using model::ModelError;
using model::Position;
using Level = Value::Level;

constexpr std::size_t longest_text = std::size_t{1} << 20U;

/// A scalar from texts; refuses what would be larger than any model.
Value made(std::string text, Level level, Position at) {
    if (text.size() > longest_text)
        throw ModelError(at, "this is too long for a model: state a smaller problem");
    return Value::scalar(std::move(text), level);
}

std::string in_brackets_below(const Value& a, Level level) {
    return a.level < level ? "(" + a.text + ")" : a.text;
}

[[noreturn]] void fail(Position at, const std::string& what, const Value& a, const Value& b) {
    throw ModelError(at, "found " + description(a) + " and " + description(b) + ": " + what);
}

template <class Operation>
Value each(const Value& a, const Value& b, Position at, const Operation& operation) {
    if (a.items.size() != b.items.size()) fail(at, "+ and - need equal shapes", a, b);
    std::vector<Value> items;
    for (std::size_t i = 0; i < a.items.size(); ++i)
        items.push_back(operation(a.items[i], b.items[i], at));
    return Value::list(std::move(items));
}

Value scaled(const Value& list, const Value& factor, bool from_left, Position at) {
    std::vector<Value> items;
    for (const Value& item : list.items)
        items.push_back(from_left ? product(factor, item, at) : product(item, factor, at));
    return Value::list(std::move(items));
}

Value column(const Value& matrix, std::size_t j) {
    std::vector<Value> items;
    for (const Value& row : matrix.items)
        items.push_back(row.items[j]);
    return Value::list(std::move(items));
}

Value matrix_product(const Value& a, const Value& b, Position at) {
    if (a.columns() != b.items.size()) fail(at, "their product is not defined", a, b);
    if (!b.is_matrix() && a.rows() == 1) return dot(a.items[0], b, at);
    std::vector<Value> rows;
    for (const Value& row : a.items) {
        if (!b.is_matrix()) {
            rows.push_back(dot(row, b, at));
            continue;
        }
        std::vector<Value> entries;
        for (std::size_t j = 0; j < b.columns(); ++j)
            entries.push_back(dot(row, column(b, j), at));
        rows.push_back(Value::list(std::move(entries)));
    }
    return Value::list(std::move(rows));
}

/// Without leading zeros; groups of three digits where the number is too large for a constant.
Value integer(std::string digits, Position at) {
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
    constexpr std::size_t longest = 60, longest_constant = 6, group = 3;
    if (digits.size() > longest)
        throw ModelError(at, "found a number of " + std::to_string(digits.size()) +
                                 " digits: a model has numbers of at most 60");
    if (digits.size() <= longest_constant) return Value::scalar(digits);
    const std::size_t rest = digits.size() - group;
    const Value head = integer(digits.substr(0, rest), at);
    const Value tail = integer(digits.substr(rest), at);
    return sum(product(head, Value::scalar("1000"), at), tail, at);
}

} // namespace

bool Value::is_matrix() const {
    return is_list && !items.empty() && std::ranges::all_of(items, [&](const Value& row) {
               return row.is_list && !row.items.empty() &&
                      row.items.size() == items[0].items.size() &&
                      std::ranges::none_of(row.items, &Value::is_list);
           });
}

std::string description(const Value& value) {
    if (!value.is_list) return "a scalar";
    if (value.is_matrix())
        return "a " + std::to_string(value.rows()) + " by " + std::to_string(value.columns()) +
               " matrix";
    return "a list of " + std::to_string(value.items.size());
}

Value number(const std::string& digits, Position at) {
    const std::size_t exponent_at = std::min(digits.find_first_of("eE"), digits.size());
    std::string mantissa = digits.substr(0, exponent_at);
    constexpr int largest_exponent = 40;
    int exponent = 0;
    if (exponent_at < digits.size()) {
        const std::string text = digits.substr(exponent_at + 1);
        if (text.size() > 3)
            throw ModelError(at, "found a number with the exponent " + text + ": it is too large");
        exponent = std::stoi(text);
    }
    const std::size_t point = mantissa.find('.');
    if (point != std::string::npos) {
        exponent -= static_cast<int>(mantissa.size() - point - 1);
        mantissa.erase(point, 1);
    }
    if (std::abs(exponent) > largest_exponent)
        throw ModelError(at, "found a number with too many digits before or after the point");
    const std::string zeros(static_cast<std::size_t>(std::abs(exponent)), '0');
    if (exponent >= 0) return integer(mantissa + zeros, at);
    return quotient(integer(mantissa, at), integer("1" + zeros, at), at);
}

std::vector<Value> scalars(const Value& value) {
    if (!value.is_list) return {value};
    std::vector<Value> result;
    for (const Value& item : value.items)
        for (Value& scalar : scalars(item))
            result.push_back(std::move(scalar));
    return result;
}

Value sum(const Value& a, const Value& b, Position at) {
    if (a.is_ideal && b.is_ideal) {
        Value joined = a;
        joined.items.insert(joined.items.end(), b.items.begin(), b.items.end());
        return joined;
    }
    if (a.is_list && b.is_list) return each(a, b, at, sum);
    if (a.is_list || b.is_list) fail(at, "+ and - need equal shapes", a, b);
    if (a.is("0")) return b;
    if (b.is("0")) return a;
    if (b.text.front() == '-') return made(a.text + " - " + b.text.substr(1), Level::sum, at);
    return made(a.text + " + " + b.text, Level::sum, at);
}

Value difference(const Value& a, const Value& b, Position at) {
    if (a.is_list && b.is_list) return each(a, b, at, difference);
    if (a.is_list || b.is_list) fail(at, "+ and - need equal shapes", a, b);
    if (a.is("0")) return negative(b, at);
    if (b.is("0")) return a;
    return made(a.text + " - " + in_brackets_below(b, Level::product), Level::sum, at);
}

Value negative(const Value& a, Position at) {
    if (a.is_list) return scaled(a, Value::scalar("-1", Level::sum), true, at);
    if (a.is("0")) return a;
    return made("-" + in_brackets_below(a, Level::product), Level::sum, at);
}

Value product(const Value& a, const Value& b, Position at) {
    if (a.is_list && b.is_list) {
        if (!a.is_matrix()) fail(at, "their product is not defined; dot(a, b) is a scalar", a, b);
        return matrix_product(a, b, at);
    }
    if (a.is_list) return scaled(a, b, false, at);
    if (b.is_list) return scaled(b, a, true, at);
    if (a.is("0") || b.is("0")) return Value::scalar("0");
    if (a.is("1")) return b;
    if (b.is("1")) return a;
    if (a.is("-1")) return negative(b, at);
    return made(in_brackets_below(a, Level::product) + "*" +
                    (b.level == Level::atom ? b.text : "(" + b.text + ")"),
                Level::product, at);
}

Value quotient(const Value& a, const Value& b, Position at) {
    if (b.is_list) fail(at, "only scalars divide", a, b);
    if (b.is("0")) throw ModelError(at, "this divides by 0");
    if (b.is("1")) return a;
    if (a.is_list) return scaled(a, quotient(Value::scalar("1"), b, at), true, at);
    return made(in_brackets_below(a, Level::product) + "/" + in_brackets_below(b, Level::atom),
                Level::product, at);
}

Value power(const Value& a, int exponent, Position at) {
    constexpr int most = 100, most_at_once = 20;
    if (exponent < 0 || exponent > most)
        throw ModelError(at, "an exponent is a whole number from 0 to 100");
    if (a.is_list && (!a.is_matrix() || a.rows() != a.columns() || exponent == 0))
        throw ModelError(at, "found a power of " + description(a));
    if (exponent == 0) return Value::scalar("1");
    if (exponent == 1) return a;
    if (a.is_list) return product(power(a, exponent - 1, at), a, at);
    const int first = std::min(exponent, most_at_once);
    const Value result =
        made(in_brackets_below(a, Level::atom) + "^" + std::to_string(first), Level::product, at);
    return exponent == first ? result : product(result, power(a, exponent - first, at), at);
}

Value transposed(const Value& a, Position at) {
    if (!a.is_list) return a;
    if (!a.is_matrix()) {
        if (std::ranges::any_of(a.items, &Value::is_list) || a.items.empty())
            throw ModelError(at, "found the transpose of " + description(a));
        return Value::list({a}); // a column becomes a row
    }
    std::vector<Value> rows;
    for (std::size_t j = 0; j < a.columns(); ++j)
        rows.push_back(column(a, j));
    return Value::list(std::move(rows));
}

Value determinant(const Value& a, Position at) {
    constexpr std::size_t most_rows = 6;
    if (!a.is_matrix() || a.rows() != a.columns() || a.rows() > most_rows)
        throw ModelError(at, "found the determinant of " + description(a) +
                                 ": it needs a square matrix of at most 6 rows");
    if (a.rows() == 1) return a.items[0].items[0];
    Value result = Value::scalar("0");
    for (std::size_t j = 0; j < a.columns(); ++j) {
        std::vector<Value> rows(a.items.begin() + 1, a.items.end());
        for (Value& row : rows)
            row.items.erase(row.items.begin() + static_cast<std::ptrdiff_t>(j));
        const Value term =
            product(a.items[0].items[j], determinant(Value::list(std::move(rows)), at), at);
        result = j % 2 == 0 ? sum(result, term, at) : difference(result, term, at);
    }
    return result;
}

Value dot(const Value& a, const Value& b, Position at) {
    if (!a.is_list || a.items.size() != b.items.size()) fail(at, "they have no product", a, b);
    Value result = Value::scalar("0");
    for (std::size_t i = 0; i < a.items.size(); ++i)
        result = sum(result, product(a.items[i], b.items[i], at), at);
    return result;
}

Value cross(const Value& a, const Value& b, Position at) {
    constexpr std::size_t size = 3;
    if (a.items.size() != size || b.items.size() != size)
        fail(at, "cross needs two of three", a, b);
    std::vector<Value> items;
    for (std::size_t i = 0; i < size; ++i) {
        const std::size_t j = (i + 1) % size, k = (i + 2) % size;
        items.push_back(difference(product(a.items[j], b.items[k], at),
                                   product(a.items[k], b.items[j], at), at));
    }
    return Value::list(std::move(items));
}

} // namespace plprove::importers
