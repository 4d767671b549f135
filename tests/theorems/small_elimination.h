// How many solutions a few polynomials have, modulo a small prime: a basis of the residue classes,
// from products of a bounded degree.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace axis {

/// An integer modulo 65521.
struct Number {
    static constexpr std::uint32_t prime = 65521;
    std::uint32_t value = 0;

    constexpr Number() = default;
    constexpr Number(std::uint32_t x) : value(x % prime) {} // NOLINT: numbers are written as such
    constexpr bool operator==(const Number&) const = default;
    constexpr Number operator+(Number b) const { return {value + b.value}; }
    constexpr Number operator-() const { return {prime - value}; }
    constexpr Number operator-(Number b) const { return *this + -b; }
    constexpr Number operator*(Number b) const { return {value * b.value}; } // less than 2^32

    constexpr Number inverse() const {
        Number power = 1, square = *this;
        for (std::uint32_t rest = prime - 2; rest != 0; rest /= 2, square = square * square)
            if (rest % 2 == 1) power = power * square;
        return power;
    }
};

inline constexpr std::size_t unknowns = 10;

/// Coefficients of the unknowns, and last the constant.
using Affine = std::array<Number, unknowns + 1>;

/// That m[0] m[3] - m[1] m[2] = 0.
using Condition = std::array<Affine, 4>;

/// Polynomials of degree at most some D as rows: monomials in order, those of large degree first.
class Elimination {
public:
    explicit Elimination(std::size_t degree) : degree_(degree) {
        for (std::size_t d = degree + 1; d-- > 0;)
            add_monomials(d, 0, {});
        for (std::size_t m = 0; m < monomials_.size(); ++m)
            index_.emplace(monomials_[m], m);
        pivots_.resize(monomials_.size());
    }

    /// Adds all multiples of a condition of degree at most D; and those of what becomes new so.
    void add(const Condition& m) {
        Row row(monomials_.size());
        add_product(row, m[0], m[3], 1);
        add_product(row, m[1], m[2], Number(0) - Number(1));
        std::vector<Row> queue = {row};
        while (!queue.empty()) {
            Row next = std::move(queue.back());
            queue.pop_back();
            const auto place = insert(next);
            if (!place) continue;
            if (degree_of(*place) == degree_) continue;
            for (std::size_t v = 0; v < unknowns; ++v)
                queue.push_back(multiple(pivots_[*place], v));
        }
    }

    /// The number of monomials that lead no polynomial. If none has the degree D, all others are
    /// combinations of them modulo the polynomials, and this bounds the number of solutions.
    std::optional<std::size_t> dimension() const {
        std::size_t count = 0;
        for (std::size_t m = 0; m < monomials_.size(); ++m) {
            if (!pivots_[m].empty()) continue;
            if (degree_of(m) == degree_) return std::nullopt;
            ++count;
        }
        return count;
    }

private:
    using Monomial = std::array<std::uint8_t, unknowns>;
    using Row = std::vector<std::uint64_t>;

    void add_monomials(std::size_t rest, std::size_t variable, Monomial m) {
        if (variable + 1 == unknowns) {
            m[variable] = static_cast<std::uint8_t>(rest);
            monomials_.push_back(m);
            return;
        }
        for (std::size_t k = rest + 1; k-- > 0;) {
            m[variable] = static_cast<std::uint8_t>(k);
            add_monomials(rest - k, variable + 1, m);
        }
    }

    std::size_t degree_of(std::size_t m) const {
        std::size_t sum = 0;
        for (const std::uint8_t e : monomials_[m])
            sum += e;
        return sum;
    }

    void add_product(Row& row, const Affine& a, const Affine& b, Number sign) const {
        for (std::size_t i = 0; i <= unknowns; ++i)
            for (std::size_t j = 0; j <= unknowns; ++j) {
                Monomial m{};
                if (i < unknowns) ++m[i];
                if (j < unknowns) ++m[j];
                std::uint64_t& entry = row[index_.at(m)];
                entry = (Number(static_cast<std::uint32_t>(entry)) + sign * a[i] * b[j]).value;
            }
    }

    /// Of a row that leads with less than the degree D.
    Row multiple(const Row& row, std::size_t variable) const {
        Row result(row.size());
        for (std::size_t m = 0; m < row.size(); ++m) {
            if (row[m] == 0) continue;
            Monomial next = monomials_[m];
            ++next[variable];
            result[index_.at(next)] = row[m];
        }
        return result;
    }

    /// Reduces a row by those before; its place, if something is left. Entries stay below 2^64, as
    /// there are far fewer than 2^32 rows.
    std::optional<std::size_t> insert(Row& row) {
        for (std::size_t m = 0; m < row.size(); ++m) {
            row[m] %= Number::prime;
            if (row[m] == 0) continue;
            if (pivots_[m].empty()) {
                const Number scale = Number(static_cast<std::uint32_t>(row[m])).inverse();
                for (std::size_t k = m; k < row.size(); ++k)
                    row[k] = row[k] % Number::prime * scale.value % Number::prime;
                pivots_[m] = std::move(row);
                return m;
            }
            const std::uint64_t factor = Number::prime - row[m];
            const std::uint64_t* pivot = pivots_[m].data();
            for (std::size_t k = m; k < row.size(); ++k)
                row[k] += factor * pivot[k];
            row[m] = 0;
        }
        return std::nullopt;
    }

    std::size_t degree_;
    std::vector<Monomial> monomials_;
    std::map<Monomial, std::size_t> index_;
    std::vector<Row> pivots_; // by the monomial that leads; empty if there is none
};

/// A bound on the number of solutions from products of degree at most this; 0 if it is too small.
inline std::size_t solutions(const std::vector<Condition>& conditions, std::size_t degree) {
    Elimination elimination(degree);
    for (const Condition& condition : conditions)
        elimination.add(condition);
    return elimination.dimension().value_or(0);
}

} // namespace axis
