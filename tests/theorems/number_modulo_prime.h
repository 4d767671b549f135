// The field with 2147483629 elements, for the numbers of a theorem's tests.
#pragma once

#include <cstdint>

namespace theorems {

constexpr std::uint64_t prime = 2147483629;

/// Modulo the prime.
struct Number {
    std::uint64_t value = 0;
    Number() = default;
    Number(std::int64_t n)
        : value(static_cast<std::uint64_t>((n % std::int64_t{prime} + std::int64_t{prime}) %
                                           std::int64_t{prime})) {}
    friend Number operator+(Number a, Number b) { return of(a.value + b.value); }
    friend Number operator-(Number a, Number b) { return of(a.value + prime - b.value); }
    friend Number operator*(Number a, Number b) { return of(a.value * b.value); }
    friend Number operator/(Number a, Number b) { return a * power(b, prime - 2); }
    static Number power(Number a, std::uint64_t exponent) {
        Number result = 1;
        for (; exponent > 0; exponent >>= 1, a = a * a)
            if (exponent & 1) result = result * a;
        return result;
    }
    std::int64_t small() const {
        return value > prime / 2 ? static_cast<std::int64_t>(value) - std::int64_t{prime}
                                 : static_cast<std::int64_t>(value);
    }

private:
    static Number of(std::uint64_t n) {
        Number result;
        result.value = n % prime;
        return result;
    }
};

} // namespace theorems
