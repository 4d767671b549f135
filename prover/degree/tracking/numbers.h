// Complex numbers and vectors of the path tracker, of the lanes that the including file is compiled
// for; with twice or three times as many digits if that file defines PLC_DOUBLE_DOUBLE or
// PLC_TRIPLE_DOUBLE.
//
// No function of the standard library is used here: see lanes.h.
#pragma once

#include "prover/degree/tracking/multiple_doubles.h"

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

template <class R>
struct Complexes {
    R re, im;
};
template <class R>
[[gnu::always_inline]] inline Complexes<R> operator+(Complexes<R> a, Complexes<R> b) {
    return {a.re + b.re, a.im + b.im};
}
template <class R>
[[gnu::always_inline]] inline Complexes<R> operator-(Complexes<R> a, Complexes<R> b) {
    return {a.re - b.re, a.im - b.im};
}
template <class R>
[[gnu::always_inline]] inline Complexes<R> operator*(Complexes<R> a, Complexes<R> b) {
    return {fnma(a.im, b.im, a.re * b.re), fma(a.re, b.im, a.im * b.re)};
}
/// sum + a b and sum - a b.
template <class R>
[[gnu::always_inline]] inline Complexes<R> add(Complexes<R> sum, Complexes<R> a, Complexes<R> b) {
    return {fnma(a.im, b.im, fma(a.re, b.re, sum.re)), fma(a.re, b.im, fma(a.im, b.re, sum.im))};
}
template <class R>
[[gnu::always_inline]] inline Complexes<R> subtract(Complexes<R> sum, Complexes<R> a,
                                                    Complexes<R> b) {
    return {fma(a.im, b.im, fnma(a.re, b.re, sum.re)), fnma(a.re, b.im, fnma(a.im, b.re, sum.im))};
}
template <class R>
[[gnu::always_inline]] inline Complexes<R> negative(Complexes<R> a) {
    return {R::of(0) - a.re, R::of(0) - a.im};
}
template <class R>
[[gnu::always_inline]] inline Complexes<R> twice(Complexes<R> a) {
    return {a.re + a.re, a.im + a.im};
}
template <class R>
[[gnu::always_inline]] inline Complexes<R> constant(const double* x) {
    return {R::of(x[0]), R::of(x[1])};
}

template <class R>
struct Vectors {
    Complexes<R> x[3];
};
template <class R>
[[gnu::always_inline]] inline Complexes<R> dot(const Vectors<R>& a, const Vectors<R>& b) {
    return add(add(a.x[0] * b.x[0], a.x[1], b.x[1]), a.x[2], b.x[2]);
}
template <class R>
[[gnu::always_inline]] inline Vectors<R> cross(const Vectors<R>& a, const Vectors<R>& b) {
    return {{subtract(a.x[1] * b.x[2], a.x[2], b.x[1]), subtract(a.x[2] * b.x[0], a.x[0], b.x[2]),
             subtract(a.x[0] * b.x[1], a.x[1], b.x[0])}};
}
template <class R>
[[gnu::always_inline]] inline Vectors<R> operator-(const Vectors<R>& a, const Vectors<R>& b) {
    return {{a.x[0] - b.x[0], a.x[1] - b.x[1], a.x[2] - b.x[2]}};
}

using Number = Complexes<Real>;
using Vector = Vectors<Real>;

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
