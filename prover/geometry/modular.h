// Integers modulo q, as a field.
#pragma once

#include "prover/geometry/flint.h"

namespace plprove {

/// A residue modulo q, 0 at first.
class Modular {
public:
    constexpr Modular() = default;
    constexpr explicit Modular(std::int64_t integer) : value_(residue(integer)) {}

    /// Of a residue: `value` is less than q.
    static constexpr Modular of(Residue value) {
        Modular result;
        result.value_ = value;
        return result;
    }

    constexpr Residue value() const { return value_; }
    constexpr bool is_zero() const { return value_ == 0; }
    constexpr bool operator==(const Modular&) const = default;

    friend constexpr Modular operator+(Modular a, Modular b) { return folded(a.value_ + b.value_); }
    friend constexpr Modular operator-(Modular a, Modular b) {
        return folded(a.value_ + modulus - b.value_);
    }
    constexpr Modular operator-() const { return of(value_ == 0 ? 0 : modulus - value_); }
    /// As 2^61 = 1, the bits of the product above the lowest 61 are added to these.
    friend Modular operator*(Modular a, Modular b) {
        constexpr int bits = 61, above = 64 - bits;
        ulong high = 0, low = 0;
        umul_ppmm(high, low, a.value_, b.value_);
        return folded((low & modulus) + (high << above | low >> bits));
    }

    /// The inverse of a residue other than 0.
    Modular inverse() const { return of(n_invmod(value_, modulus)); }

private:
    /// Of a number less than 2 q.
    static constexpr Modular folded(Residue value) {
        return of(value >= modulus ? value - modulus : value);
    }

    Residue value_ = 0;
};

} // namespace plprove
