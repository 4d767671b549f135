// Complex numbers of many digits. No error is bounded: what is made of them is tested exactly.
#pragma once

#include "prover/model/prime_field.h"

#include <cstdint>
#include <utility>
// FLINT 3 has Arb inside.
#if __has_include(<flint/acb_mat.h>)
#include <flint/acb_mat.h>
#include <flint/arb_poly.h>
#else
#include <acb_mat.h>
#include <arb_poly.h>
#endif

namespace plprove::model {

class BigComplex {
public:
    BigComplex() { acb_init(value_); }
    BigComplex(const BigComplex& other) : BigComplex() { acb_set(value_, other.value_); }
    BigComplex(BigComplex&& other) noexcept : BigComplex() { acb_swap(value_, other.value_); }
    BigComplex& operator=(BigComplex other) noexcept {
        acb_swap(value_, other.value_);
        return *this;
    }
    ~BigComplex() { acb_clear(value_); }

    acb_struct* get() { return value_; }
    const acb_struct* get() const { return value_; }

private:
    acb_t value_;
};

/// Arithmetic with so many bits, as a field for templates.
struct ManyDigits {
    using Element = BigComplex;

    slong bits = 0;

    BigComplex scaled(const BigComplex& a, std::int64_t factor) const {
        BigComplex result;
        acb_mul_si(result.get(), a.get(), factor, bits);
        return middle(std::move(result));
    }
    BigComplex constant(std::int64_t value) const {
        BigComplex result;
        acb_set_si(result.get(), value);
        return result;
    }
    BigComplex sum(const BigComplex& a, const BigComplex& b) const {
        BigComplex result;
        acb_add(result.get(), a.get(), b.get(), bits);
        return middle(std::move(result));
    }
    BigComplex difference(const BigComplex& a, const BigComplex& b) const {
        BigComplex result;
        acb_sub(result.get(), a.get(), b.get(), bits);
        return middle(std::move(result));
    }
    BigComplex product(const BigComplex& a, const BigComplex& b) const {
        BigComplex result;
        acb_mul(result.get(), a.get(), b.get(), bits);
        return middle(std::move(result));
    }
    /// Throws NotInvertible if a is 0.
    BigComplex inverse(const BigComplex& a) const {
        if (is_zero(a)) throw NotInvertible();
        BigComplex result;
        acb_inv(result.get(), a.get(), bits);
        return middle(std::move(result));
    }
    static bool is_zero(const BigComplex& a) { return acb_is_zero(a.get()) != 0; }

private:
    static BigComplex middle(BigComplex a) {
        mag_zero(arb_radref(acb_realref(a.get())));
        mag_zero(arb_radref(acb_imagref(a.get())));
        return a;
    }
};

} // namespace plprove::model
