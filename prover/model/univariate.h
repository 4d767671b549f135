// Polynomials in one variable t modulo q.
#pragma once

#include "prover/geometry/modular.h"

#include <flint/nmod_poly.h>
#include <vector>

namespace plprove::model {

/// A polynomial in t, 0 at first.
class Univariate {
public:
    Univariate() { nmod_poly_init(value_, modulus); }
    /// With the coefficients of 1, t, t^2, ...
    explicit Univariate(const std::vector<Modular>& coefficients);
    Univariate(const Univariate& other) : Univariate() { nmod_poly_set(value_, other.value_); }
    Univariate(Univariate&& other) noexcept : Univariate() { swap(other); }
    Univariate& operator=(Univariate other) noexcept {
        swap(other);
        return *this;
    }
    ~Univariate() { nmod_poly_clear(value_); }

    nmod_poly_struct* get() { return value_; }
    const nmod_poly_struct* get() const { return value_; }
    std::size_t degree() const; ///< that of 0 is 0
    bool is_zero() const { return nmod_poly_is_zero(value_) != 0; }
    Modular coefficient(std::size_t power) const;

private:
    void swap(Univariate& other) noexcept { nmod_poly_swap(value_, other.value_); }
    nmod_poly_t value_;
};

/// The polynomial of least degree that is a linear recurrence of the sequence, up to a factor
/// (Berlekamp and Massey).
Univariate recurrence_of(const std::vector<Modular>& sequence);

} // namespace plprove::model
