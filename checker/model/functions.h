// The operations and functions of models on arrays (FORMAT.md, section 16, *Values*).
#pragma once

#include "checker/model/value.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace checker {
/// Calculates with arrays. Members throw Senseless where shapes do not fit.
template <class Ring> class Arrays {
public:
    using Scalar = Fraction<typename Ring::Element>;
    using Value = Array<Scalar>;

    explicit Arrays(Ring& ring) : scalars(ring) {}

    Fractions<Ring> scalars;

    Value number(int value) const { return {{}, {scalars.constant(value)}}; }

    Value list(const std::vector<Value>& parts) const {
        Value all{.shape = parts[0].shape};
        for (const Value& part : parts) {
            require(part.shape == parts[0].shape, "the items of a list have different shapes");
            all.items.insert(all.items.end(), part.items.begin(), part.items.end());
        }
        all.shape.insert(all.shape.begin(), parts.size());
        return all;
    }

    Value item(const Value& array, std::int64_t index) const {
        require(!array.is_scalar(), "a scalar has no items");
        require(index >= 1 && static_cast<std::size_t>(index) <= array.shape[0],
                say("there is no item ", index));
        const std::size_t size = array.items.size() / array.shape[0];
        const auto first = array.items.begin() +
                           static_cast<std::ptrdiff_t>(size * static_cast<std::size_t>(index - 1));
        return {{array.shape.begin() + 1, array.shape.end()},
                {first, first + static_cast<std::ptrdiff_t>(size)}};
    }

    Value negative(Value a) const {
        for (Scalar& item : a.items)
            item = scalars.negative(item);
        return a;
    }

    Value add(Value a, const Value& b) const {
        require(a.shape == b.shape, "sums need equal shapes");
        for (std::size_t i = 0; i < a.items.size(); ++i)
            a.items[i] = scalars.add(a.items[i], b.items[i]);
        return a;
    }

    Value subtract(const Value& a, const Value& b) const { return add(a, negative(b)); }

    Value multiply(const Value& a, const Value& b) const {
        if (a.is_scalar()) return scaled(b, a.items[0]);
        if (b.is_scalar()) return scaled(a, b.items[0]);
        require(
            a.is_matrix() && (b.is_vector() || b.is_matrix()) && a.shape[1] == b.shape[0],
            "a product needs a scalar, or a matrix and what it fits: use dot or cross for vectors");
        const std::size_t columns = b.is_matrix() ? b.shape[1] : 1;
        Value product{.shape = b.shape};
        product.shape[0] = a.shape[0];
        for (std::size_t i = 0; i < a.shape[0]; ++i)
            for (std::size_t k = 0; k < columns; ++k) {
                Scalar sum = scalars.multiply(a.at(i, 0), b.items[k]);
                for (std::size_t j = 1; j < a.shape[1]; ++j)
                    sum = scalars.add(sum, scalars.multiply(a.at(i, j), b.items[j * columns + k]));
                product.items.push_back(std::move(sum));
            }
        return product;
    }

    Value divide(const Value& a, const Value& b) {
        require(b.is_scalar(), "a divisor is a scalar");
        return scaled(a, scalars.inverse(b.items[0]));
    }

    Value power(const Value& base, int exponent) const {
        require(base.is_scalar(), "only scalars have powers");
        Value result = base;
        for (int i = 1; i < exponent; ++i)
            result.items[0] = scalars.multiply(result.items[0], base.items[0]);
        return result;
    }

    /// The value of a function but `identity`, and what may not be 0.
    std::pair<Value, std::optional<Scalar>> call(const std::string& name,
                                                 const std::vector<Value>& a) const {
        if (name == "dot" && a.size() == 2) return {{{}, {dot(a[0], a[1])}}, {}};
        if (name == "norm2" && a.size() == 1) return {{{}, {dot(a[0], a[0])}}, {}};
        if (name == "cross" && a.size() == 2) {
            require_vector_of_three(a[1]);
            return {multiply(skew(a[0]), a[1]), {}};
        }
        if (name == "skew" && a.size() == 1) return {skew(a[0]), {}};
        if (name == "det" && a.size() == 1) return {{{}, {determinant(a[0])}}, {}};
        if (name == "trace" && a.size() == 1) return {{{}, {trace(a[0])}}, {}};
        if (name == "transpose" && a.size() == 1) return {transpose(a[0]), {}};
        if (name == "rotation" && a.size() == 1) return rotation(a[0]);
        throw Senseless{say("there is no function `", name, "` of ", a.size(), " values")};
    }

    Value identity(std::size_t size) const {
        Value matrix{.shape = {size, size}};
        for (std::size_t i = 0; i < size * size; ++i)
            matrix.items.push_back(scalars.constant(i % (size + 1) == 0));
        return matrix;
    }

    static void require(bool holds, const std::string& reason) {
        if (!holds) throw Senseless{reason};
    }

private:
    Value scaled(Value a, const Scalar& factor) const {
        for (Scalar& item : a.items)
            item = scalars.multiply(item, factor);
        return a;
    }

    static void require_vector_of_three(const Value& v) {
        require(v.shape == std::vector<std::size_t>{3}, "this needs vectors of three");
    }

    Scalar dot(const Value& a, const Value& b) const {
        require(a.is_vector() && a.shape == b.shape, "this needs vectors of one size");
        Scalar sum = scalars.multiply(a.items[0], b.items[0]);
        for (std::size_t i = 1; i < a.items.size(); ++i)
            sum = scalars.add(sum, scalars.multiply(a.items[i], b.items[i]));
        return sum;
    }

    Value skew(const Value& v) const {
        require_vector_of_three(v);
        const Scalar zero = scalars.constant(0), &x = v.items[0], &y = v.items[1], &z = v.items[2];
        const auto minus = [&](const Scalar& a) { return scalars.negative(a); };
        return {{3, 3}, {zero, minus(z), y, z, zero, minus(x), minus(y), x, zero}};
    }

    static void require_square(const Value& m) {
        require(m.is_matrix() && m.shape[0] == m.shape[1], "this needs a square matrix");
    }

    Scalar trace(const Value& m) const {
        require_square(m);
        Scalar sum = m.items[0];
        for (std::size_t i = 1; i < m.shape[0]; ++i)
            sum = scalars.add(sum, m.at(i, i));
        return sum;
    }

    Value transpose(const Value& m) const {
        require(m.is_matrix(), "only a matrix has a transpose");
        Value result{.shape = {m.shape[1], m.shape[0]}};
        for (std::size_t j = 0; j < m.shape[1]; ++j)
            for (std::size_t i = 0; i < m.shape[0]; ++i)
                result.items.push_back(m.at(i, j));
        return result;
    }

    /// By Leibniz' formula.
    Scalar determinant(const Value& m) const {
        require_square(m);
        const std::size_t size = m.shape[0];
        require(size <= 6, "a determinant has at most 6 rows");
        std::vector<std::size_t> columns(size);
        std::iota(columns.begin(), columns.end(), std::size_t{0});
        std::optional<Scalar> sum;
        do {
            Scalar product = m.at(0, columns[0]);
            bool odd = false;
            for (std::size_t i = 1; i < size; ++i) {
                product = scalars.multiply(product, m.at(i, columns[i]));
                for (std::size_t j = 0; j < i; ++j)
                    odd ^= columns[j] > columns[i];
            }
            if (odd) product = scalars.negative(product);
            sum = sum ? scalars.add(*sum, product) : product;
        } while (std::ranges::next_permutation(columns).found);
        return *sum;
    }

    /// The matrix of a quaternion (FORMAT.md, section 2), and its norm.
    std::pair<Value, std::optional<Scalar>> rotation(const Value& v) const {
        require(v.is_vector() && (v.shape[0] == 3 || v.shape[0] == 4),
                "a rotation needs a vector of three or four");
        std::vector<Scalar> q = v.items;
        if (q.size() == 3) q.insert(q.begin(), scalars.constant(1));
        const auto product = [&](std::size_t i, std::size_t j) {
            return scalars.multiply(q[i], q[j]);
        };
        const auto sum = [&](const Scalar& a, const Scalar& b) { return scalars.add(a, b); };
        const auto less = [&](const Scalar& a, const Scalar& b) { return scalars.subtract(a, b); };
        const auto twice = [&](const Scalar& a) {
            return scalars.multiply(scalars.constant(2), a);
        };
        const Scalar aa = product(0, 0), bb = product(1, 1), cc = product(2, 2), dd = product(3, 3);
        const Scalar bc = product(1, 2), bd = product(1, 3), cd = product(2, 3);
        const Scalar ab = product(0, 1), ac = product(0, 2), ad = product(0, 3);
        return {{{3, 3},
                 {less(sum(aa, bb), sum(cc, dd)), twice(less(bc, ad)), twice(sum(bd, ac)),
                  twice(sum(bc, ad)), less(sum(aa, cc), sum(bb, dd)), twice(less(cd, ab)),
                  twice(less(bd, ac)), twice(sum(cd, ab)), less(sum(aa, dd), sum(bb, cc))}},
                sum(sum(aa, bb), sum(cc, dd))};
    }
};
} // namespace checker
