// Integers modulo the prime 2^31 - 1, and ranks of matrices of such. Ranks of integer matrices are
// at least these.
#pragma once

#include "checker/algebra/modular.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace checker {
inline constexpr std::uint32_t small_prime = (std::uint32_t{1} << 31) - 1;

struct Small {
    std::uint32_t value = 0; // less than the prime

    /// Of any word: as 2^31 = 1, the bits above the lowest 31 are added to these.
    static constexpr Small of(std::uint64_t x) {
        x = (x & small_prime) + (x >> 31);
        x = (x & small_prime) + (x >> 31);
        return {static_cast<std::uint32_t>(x >= small_prime ? x - small_prime : x)};
    }

    static constexpr Small of_integer(std::int64_t x) {
        const std::int64_t rest = x % std::int64_t{small_prime};
        return of(static_cast<std::uint64_t>(rest < 0 ? rest + small_prime : rest));
    }

    constexpr bool operator==(const Small&) const = default;
    constexpr Small operator-() const { return of(std::uint64_t{small_prime} - value); }
    constexpr Small operator+(Small b) const { return of(std::uint64_t{value} + b.value); }
    constexpr Small operator-(Small b) const { return *this + -b; }
    constexpr Small operator*(Small b) const { return of(std::uint64_t{value} * b.value); }

    /// The inverse of this, if it is not 0: its power p - 2, by Fermat.
    constexpr Small inverse() const { return power(*this, small_prime - 2); }
};

using SmallRow = std::vector<Small>;
using Row3 = std::array<Small, 3>;

constexpr Small determinant(const Row3& a, const Row3& b, const Row3& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// The numbers that a checker is free to choose: always the same ones (SplitMix64).
class Choices {
public:
    Small next() {
        state_ += 0x9e3779b97f4a7c15;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return Small::of(z ^ (z >> 31));
    }

    SmallRow row(std::size_t size) {
        SmallRow numbers(size);
        for (Small& number : numbers)
            number = next();
        return numbers;
    }

private:
    std::uint64_t state_ = 0;
};

/// The span of rows of one length.
class RowSpace {
public:
    std::size_t rank() const { return rows_.size(); }

    /// Adds some rows: many at a time are faster. Returns whether one was not in the span.
    bool add(const std::vector<SmallRow>& rows);

private:
    /// Numbers below 2^63 that stand for their residues: the innermost loop reduces them by half.
    using Rest = std::vector<std::uint64_t>;

    struct Reduced {
        SmallRow row{}; // 1 at the pivot; 0 before it, and at those of the rows before
        std::size_t pivot = 0;
    };

    static void reduce(Rest& rest, const Reduced& by);
    bool add_reduced(const Rest& rest);

    std::vector<Reduced> rows_{};
};
} // namespace checker
