// Integers modulo q, as a ring.
#pragma once

#include "prover/geometry/flint.h"

namespace plprove {

/// A residue modulo q, 0 at first.
class Modular {
public:
    Modular() = default;
    explicit Modular(std::int64_t integer) : value_(residue(integer)) {}

    Residue value() const { return value_; }

    friend Modular operator+(const Modular& a, const Modular& b) {
        return of(nmod_add(a.value_, b.value_, context));
    }
    friend Modular operator-(const Modular& a, const Modular& b) {
        return of(nmod_sub(a.value_, b.value_, context));
    }
    friend Modular operator*(const Modular& a, const Modular& b) {
        return of(nmod_mul(a.value_, b.value_, context));
    }

private:
    inline static const nmod_t context = modulus_context();

    static Modular of(Residue value) {
        Modular result;
        result.value_ = value;
        return result;
    }

    Residue value_ = 0;
};

} // namespace plprove
