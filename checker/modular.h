// Arithmetic modulo the prime q = 2^61 - 1, and the determinant behind every minor.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

namespace checker {
inline constexpr std::uint64_t modulus = (std::uint64_t{1} << 61) - 1;
__extension__ using Wide = unsigned __int128;

struct Residue {
    std::uint64_t value = 0; // less than q
    /// Of x < 2^123: as 2^61 = 1, the bits above the lowest 61 are added to these, twice.
    static constexpr Residue of(Wide x) {
        const Wide once = (x & modulus) + (x >> 61);
        const auto twice = static_cast<std::uint64_t>((once & modulus) + (once >> 61));
        return {twice >= modulus ? twice - modulus : twice};
    }
    constexpr Residue operator-() const { return {value == 0 ? 0 : modulus - value}; }
    constexpr Residue operator*(Residue b) const { return of(Wide{value} * b.value); }
    constexpr bool operator==(const Residue&) const = default;
    /// The inverse of this, if it is not 0: its power q - 2, by Fermat.
    constexpr Residue inverse() const {
        Residue power{1}, square = *this;
        for (std::uint64_t rest = modulus - 2; rest != 0; rest >>= 1, square = square * square)
            if (rest & 1) power = power * square;
        return power;
    }
};

using Row = std::array<Residue, 11>;

/// Of a square matrix, a container of rows.
template <class Matrix> Residue determinant(Matrix m) {
    Residue product{1}, scale{1}; // rows are scaled on the way, so as to divide only once
    for (std::size_t c = 0; c < m.size(); ++c) {
        std::size_t place = c;
        while (place < m.size() && m[place][c] == Residue{}) ++place;
        if (place == m.size()) return {};
        if (place != c) product = -product;
        std::swap(m[c], m[place]);
        const Residue pivot = m[c][c];
        product = product * pivot;
        for (std::size_t r = c + 1; r < m.size(); ++r) {
            const Wide a = pivot.value, b = (-m[r][c]).value;
            if (b == 0) continue;
            for (std::size_t k = c; k < m.size(); ++k)
                m[r][k] = Residue::of(a * m[r][k].value + b * m[c][k].value);
            scale = scale * pivot;
        }
    }
    return product * scale.inverse();
}
} // namespace checker
