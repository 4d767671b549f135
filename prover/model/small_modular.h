// Residues modulo a prime so small that programs for computer algebra are quick with it.
#pragma once

#include "prover/geometry/flint.h"

namespace plprove::model {

/// Macaulay2 has tables of logarithms for primes up to 32749; and squares have roots that are easy
/// to compute if 4 divides the prime plus 1.
inline constexpr Residue small_prime = 32003;

/// A residue modulo that prime, 0 at first.
class SmallModular {
public:
    constexpr SmallModular() = default;
    constexpr explicit SmallModular(std::int64_t integer) {
        constexpr auto prime = static_cast<std::int64_t>(small_prime);
        value_ = static_cast<Residue>((integer % prime + prime) % prime);
    }

    constexpr Residue value() const { return value_; }
    constexpr bool is_zero() const { return value_ == 0; }
    constexpr bool operator==(const SmallModular&) const = default;

    friend constexpr SmallModular operator+(SmallModular a, SmallModular b) {
        return of(a.value_ + b.value_);
    }
    friend constexpr SmallModular operator-(SmallModular a, SmallModular b) {
        return of(a.value_ + small_prime - b.value_);
    }
    constexpr SmallModular operator-() const { return of(small_prime - value_); }
    friend constexpr SmallModular operator*(SmallModular a, SmallModular b) {
        return of(a.value_ * b.value_);
    }

    /// The inverse of a residue other than 0.
    SmallModular inverse() const { return of(n_invmod(value_, small_prime)); }

private:
    static constexpr SmallModular of(Residue value) {
        SmallModular result;
        result.value_ = value % small_prime;
        return result;
    }

    Residue value_ = 0;
};

} // namespace plprove::model
