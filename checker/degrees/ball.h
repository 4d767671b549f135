// Sets of complex numbers and their arithmetic, a thin cover of the library Arb: what is computed
// of sets contains all that is computed of their elements.
#pragma once

#if __has_include(<flint/acb_mat.h>)
#include <flint/acb_mat.h>
#else
#include <acb_mat.h>
#endif

#include "checker/degrees/degeneracy.h"

namespace checker {
/// A rectangle in the complex plane, whose midpoint has `bits` bits.
template <slong bits> class Ball {
public:
    Ball() { acb_init(value_); }
    explicit Ball(double x) : Ball() { acb_set_d(value_, x); }
    explicit Ball(const mpz_class& x) : Ball() { // exactly, whatever its size
        fmpz_t integer;
        fmpz_init(integer);
        fmpz_set_mpz(integer, x.get_mpz_t());
        acb_set_fmpz(value_, integer);
        fmpz_clear(integer);
    }
    Ball(const Ball& other) : Ball() { acb_set(value_, other.value_); }
    Ball(Ball&& other) noexcept : Ball() { acb_swap(value_, other.value_); }
    ~Ball() { acb_clear(value_); }
    Ball& operator=(Ball other) noexcept {
        acb_swap(value_, other.value_);
        return *this;
    }

    acb_ptr get() { return value_; }
    acb_srcptr get() const { return value_; }

    Ball operator+(const Ball& other) const { return combine(acb_add, other); }
    Ball operator-(const Ball& other) const { return combine(acb_sub, other); }
    Ball operator*(const Ball& other) const { return combine(acb_mul, other); }
    Ball operator-() const { return Ball() - *this; }

private:
    template <class Operation> Ball combine(Operation operation, const Ball& other) const {
        Ball result;
        operation(result.value_, value_, other.value_, bits);
        return result;
    }

    acb_t value_;
};

template <slong bits> bool nonzero(const Ball<bits>& x) {
    return !acb_contains_zero(x.get());
}

template <slong bits> Ball<bits> dot(const Vector3<Ball<bits>>& a, const Vector3<Ball<bits>>& b) {
    static_assert(sizeof(a) == 3 * sizeof(acb_struct)); // an array of acb_t
    Ball<bits> sum;
    acb_dot(sum.get(), nullptr, 0, a[0].get(), 1, b[0].get(), 1, 3, bits);
    return sum;
}

/// An upper bound of the absolute value, up to an underflow.
inline double magnitude(acb_srcptr x) {
    mag_t bound;
    mag_init(bound);
    acb_get_mag(bound, x);
    const double result = mag_get_d(bound);
    mag_clear(bound);
    return result;
}

/// A matrix of balls.
class BallMatrix {
public:
    BallMatrix(std::size_t rows, std::size_t columns) {
        acb_mat_init(entries_, slong(rows), slong(columns));
    }
    BallMatrix(const BallMatrix&) = delete;
    BallMatrix& operator=(const BallMatrix&) = delete;
    ~BallMatrix() { acb_mat_clear(entries_); }

    acb_mat_struct* get() { return entries_; }
    acb_ptr at(std::size_t row, std::size_t column) {
        return acb_mat_entry(entries_, slong(row), slong(column));
    }

private:
    acb_mat_t entries_;
};
} // namespace checker
