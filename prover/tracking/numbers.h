// Complex numbers and vectors of the path tracker, of the lanes that the including file is compiled
// for; with twice or three times the digits if that file defines PLC_DOUBLE_DOUBLE or
// PLC_TRIPLE_DOUBLE.
//
// No function of the standard library is used here: see lanes.h.
#pragma once

#include "prover/tracking/multiple_doubles.h"

namespace plprove::PLC_LANES {

namespace {

#if defined(PLC_DOUBLE_DOUBLE) || defined(PLC_TRIPLE_DOUBLE)
#if defined(PLC_DOUBLE_DOUBLE)
using Real = DoubleDouble;
#else
using Real = TripleDouble;
#endif
#undef PLC_UNROLLED
#define PLC_UNROLLED // a column does not fit into the registers
#endif

struct Number {
    Real re, im;
};
[[gnu::always_inline]] inline Number operator+(Number a, Number b) {
    return {a.re + b.re, a.im + b.im};
}
[[gnu::always_inline]] inline Number operator-(Number a, Number b) {
    return {a.re - b.re, a.im - b.im};
}
[[gnu::always_inline]] inline Number operator*(Number a, Number b) {
    return {fnma(a.im, b.im, a.re * b.re), fma(a.re, b.im, a.im * b.re)};
}
/// sum + a b and sum - a b.
[[gnu::always_inline]] inline Number add(Number sum, Number a, Number b) {
    return {fnma(a.im, b.im, fma(a.re, b.re, sum.re)), fma(a.re, b.im, fma(a.im, b.re, sum.im))};
}
[[gnu::always_inline]] inline Number subtract(Number sum, Number a, Number b) {
    return {fma(a.im, b.im, fnma(a.re, b.re, sum.re)), fnma(a.re, b.im, fnma(a.im, b.re, sum.im))};
}
[[gnu::always_inline]] inline Number negative(Number a) {
    return {Real::of(0) - a.re, Real::of(0) - a.im};
}
[[gnu::always_inline]] inline Number twice(Number a) {
    return {a.re + a.re, a.im + a.im};
}
[[gnu::always_inline]] inline Number constant(const double* x) {
    return {Real::of(x[0]), Real::of(x[1])};
}

struct Vector {
    Number x[3];
};
[[gnu::always_inline]] inline Number dot(const Vector& a, const Vector& b) {
    return add(add(a.x[0] * b.x[0], a.x[1], b.x[1]), a.x[2], b.x[2]);
}
[[gnu::always_inline]] inline Vector cross(const Vector& a, const Vector& b) {
    return {{subtract(a.x[1] * b.x[2], a.x[2], b.x[1]), subtract(a.x[2] * b.x[0], a.x[0], b.x[2]),
             subtract(a.x[0] * b.x[1], a.x[1], b.x[0])}};
}
[[gnu::always_inline]] inline Vector operator-(const Vector& a, const Vector& b) {
    return {{a.x[0] - b.x[0], a.x[1] - b.x[1], a.x[2] - b.x[2]}};
}

inline Real square(Number a) {
    return fma(a.re, a.re, a.im * a.im);
}
inline Number select(Mask m, Number a, Number b) {
    return {select(m, a.re, b.re), select(m, a.im, b.im)};
}
inline Real larger(Real a, Real b) {
    return select(less(a, b), b, a);
}
inline Real smaller(Real a, Real b) {
    return select(less(a, b), a, b);
}

} // namespace

} // namespace plprove::PLC_LANES
