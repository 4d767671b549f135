// Arithmetic modulo q = 2^61 - 1, a prime (Mersenne's ninth), and the determinant behind every
// minor.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace checker {

/// A matrix, stored by rows.
template <class Entry>
struct Matrix {
    std::size_t rows = 0, columns = 0;
    std::vector<Entry> entries = std::vector<Entry>(rows * columns);

    Entry* operator[](std::size_t row) { return entries.data() + row * columns; }
    const Entry* operator[](std::size_t row) const { return entries.data() + row * columns; }
};

inline constexpr std::uint64_t modulus = (std::uint64_t{1} << 61) - 1;
__extension__ using Wide = unsigned __int128;

/// A number modulo q.
struct Residue {
    std::uint64_t value = 0; // less than q

    /// Of x < 2^123: as 2^61 = 1, the bits above the lowest 61 are added to these, twice.
    static constexpr Residue of(Wide x) {
        const std::uint64_t once =
            (static_cast<std::uint64_t>(x) & modulus) + static_cast<std::uint64_t>(x >> 61);
        const std::uint64_t twice = (once & modulus) + (once >> 61);
        return {twice >= modulus ? twice - modulus : twice};
    }
    constexpr Residue operator-() const { return {value == 0 ? 0 : modulus - value}; }
    constexpr Residue operator*(Residue b) const { return of(Wide{value} * b.value); }
    constexpr bool operator==(const Residue&) const = default;

    /// The inverse of this, if it is not 0: its power q - 2, by Fermat.
    constexpr Residue inverse() const {
        Residue power{1}, square = *this;
        for (std::uint64_t exponent = modulus - 2; exponent != 0; exponent >>= 1) {
            if (exponent & 1) power = power * square;
            square = square * square;
        }
        return power;
    }
};

/// The determinant of a square matrix.
inline Residue determinant(Matrix<Residue> m) {
    Residue product{1},
        scale{1}; // rows are scaled on the way, so as to divide only once, at the end
    for (std::size_t c = 0; c < m.columns; ++c) {
        std::size_t pivot = c;
        while (pivot < m.rows && m[pivot][c] == Residue{})
            ++pivot;
        if (pivot == m.rows) return {};
        if (pivot != c) product = -product;
        std::swap_ranges(m[c], m[c] + m.columns, m[pivot]);
        const Residue a = m[c][c];
        product = product * a;
        for (std::size_t r = c + 1; r < m.rows; ++r) {
            const Residue b = -m[r][c];
            if (b == Residue{}) continue;
            for (std::size_t k = c; k < m.columns; ++k)
                m[r][k] =
                    Residue::of(Wide{a.value} * m[r][k].value + Wide{b.value} * m[c][k].value);
            scale = scale * a;
        }
    }
    return product * scale.inverse();
}

} // namespace checker
