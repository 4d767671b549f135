// Integers modulo the prime q = 2^61 - 1, and the determinant behind every minor. Words of 64 bits
// suffice, whatever the sizes of `long` and of pointers.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace checker {
inline constexpr std::uint64_t modulus = (std::uint64_t{1} << 61) - 1;

template <class Field> constexpr Field power(Field x, std::uint64_t exponent) {
    Field product{1};
    for (; exponent != 0; exponent >>= 1) {
        if (exponent & 1) product = product * x;
        x = x * x;
    }
    return product;
}

struct Residue {
    std::uint64_t value = 0; // less than q

    /// Of any word: as 2^61 = 1, the bits above the lowest 61 are added to these.
    static constexpr Residue of(std::uint64_t x) {
        const std::uint64_t folded = (x & modulus) + (x >> 61);
        return {folded >= modulus ? folded - modulus : folded};
    }

    constexpr bool operator==(const Residue&) const = default;
    constexpr Residue operator-() const { return {value == 0 ? 0 : modulus - value}; }
    constexpr Residue operator+(Residue b) const { return of(value + b.value); }
    constexpr Residue operator-(Residue b) const { return *this + -b; }

    constexpr Residue operator*(Residue b) const { return sum_of_products(*this, b, {}, {}); }

    /// a b + c d. Each factor is split, a = 2^31 high + low with high < 2^30 and low < 2^31. So the
    /// sums `high` < 2^61, `middle` < 2^63 and `low` < 2^63 below fit. As 2^62 = 2 and
    /// 2^31 2^30 = 1, the result is the sum of four numbers below 2^62, 2^33, 2^61 and 2^63, which
    /// is less than 2^64.
    static constexpr Residue sum_of_products(Residue a, Residue b, Residue c, Residue d) {
        constexpr std::uint64_t low_30 = (std::uint64_t{1} << 30) - 1;
        constexpr std::uint64_t low_31 = (std::uint64_t{1} << 31) - 1;
        const std::uint64_t a_high = a.value >> 31, a_low = a.value & low_31;
        const std::uint64_t b_high = b.value >> 31, b_low = b.value & low_31;
        const std::uint64_t c_high = c.value >> 31, c_low = c.value & low_31;
        const std::uint64_t d_high = d.value >> 31, d_low = d.value & low_31;
        const std::uint64_t high = a_high * b_high + c_high * d_high;
        const std::uint64_t middle =
            a_high * b_low + a_low * b_high + c_high * d_low + c_low * d_high;
        const std::uint64_t low = a_low * b_low + c_low * d_low;
        return of(2 * high + (middle >> 30) + ((middle & low_30) << 31) + low);
    }

    /// The inverse of this, if it is not 0: its power q - 2, by Fermat.
    constexpr Residue inverse() const { return power(*this, modulus - 2); }
};

/// The residue of an integer of any size.
inline Residue residue(const mpz_class& x) {
    static const mpz_class q = (mpz_class(1) << 61) - 1;
    mpz_class rest;
    mpz_fdiv_r(rest.get_mpz_t(), x.get_mpz_t(), q.get_mpz_t());
    Residue result;
    mpz_export(&result.value, nullptr, -1, sizeof result.value, 0, 0, rest.get_mpz_t());
    return result;
}

/// A square matrix by rows, 0 at first.
class SquareMatrix {
public:
    explicit SquareMatrix(std::size_t size) : size_(size), entries_(size * size) {}

    std::size_t size() const { return size_; }
    std::span<Residue> operator[](std::size_t row) {
        return std::span(entries_).subspan(row * size_, size_);
    }

private:
    std::size_t size_;
    std::vector<Residue> entries_;
};

/// The determinant of a square matrix, a container of rows.
template <class Matrix> Residue determinant(Matrix m) {
    Residue product{1};
    Residue scale{1}; // of the rows, which are scaled on the way so as to divide only once
    for (std::size_t c = 0; c < m.size(); ++c) {
        std::size_t place = c;
        while (place < m.size() && m[place][c] == Residue{})
            ++place;
        if (place == m.size()) return {};
        if (place != c) {
            product = -product;
            std::ranges::swap_ranges(m[c], m[place]);
        }
        const Residue pivot = m[c][c];
        product = product * pivot;
        auto&& pivot_row = m[c];
        for (std::size_t r = c + 1; r < m.size(); ++r) {
            auto&& row = m[r];
            const Residue factor = -row[c];
            if (factor == Residue{}) continue;
            for (std::size_t k = c + 1; k < m.size(); ++k)
                row[k] = Residue::sum_of_products(pivot, row[k], factor, pivot_row[k]);
            scale = scale * pivot;
        }
    }
    return product * scale.inverse();
}
} // namespace checker
