// Real numbers with twice or three times the digits of a double, several at a time: unevaluated
// sums of the lanes of lanes.h, whose operations are exact or correctly rounded.
#pragma once

#include "prover/tracking/lanes.h"

namespace plprove::PLC_LANES {

/// About 32 decimal digits: the unevaluated sum of two numbers in each lane (T. J. Dekker, Numer.
/// Math. 18, 1971; Y. Hida, X. S. Li, D. H. Bailey, ARITH-15, 2001).
struct DoubleDouble {
    static constexpr int width = Real::width;
    Real high, low;
    static DoubleDouble of(double x) { return {Real::of(x), Real::of(0)}; }
    void store(double* x) const { high.store(x); }
};
[[gnu::always_inline]] inline DoubleDouble widen(Real x) {
    return {x, Real::of(0)};
}

/// a + b exactly, if |a| >= |b|; and for any a, b.
[[gnu::always_inline]] inline DoubleDouble quick_sum(Real a, Real b) {
    const Real sum = a + b;
    return {sum, b - (sum - a)};
}
[[gnu::always_inline]] inline DoubleDouble exact_sum(Real a, Real b) {
    const Real sum = a + b, part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}
[[gnu::always_inline]] inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble high = exact_sum(a.high, b.high);
    return quick_sum(high.high, high.low + (a.low + b.low));
}
[[gnu::always_inline]] inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b) {
    const Real zero = Real::of(0);
    return a + DoubleDouble{zero - b.high, zero - b.low};
}
[[gnu::always_inline]] inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const Real high = a.high * b.high, error = rounding_error(a.high, b.high, high);
    return quick_sum(high, fma(a.high, b.low, fma(a.low, b.high, Real::of(0) - error)));
}
[[gnu::always_inline]] inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
    const Real high = a.high / b.high;
    return quick_sum(high, (a - b * widen(high)).high / b.high);
}
[[gnu::always_inline]] inline DoubleDouble fma(DoubleDouble a, DoubleDouble b, DoubleDouble c) {
    const Real high = a.high * b.high, error = rounding_error(a.high, b.high, high);
    const DoubleDouble sum = exact_sum(c.high, high);
    const Real low = fma(a.high, b.low, fma(a.low, b.high, c.low + sum.low));
    return quick_sum(sum.high, low - error);
}
[[gnu::always_inline]] inline DoubleDouble fnma(DoubleDouble a, DoubleDouble b, DoubleDouble c) {
    const Real zero = Real::of(0);
    return fma({zero - a.high, zero - a.low}, b, c);
}
/// Only as accurate as Real's: enough for the sizes of steps.
[[gnu::always_inline]] inline DoubleDouble sqrt(DoubleDouble a) {
    return widen(sqrt(a.high));
}
[[gnu::always_inline]] inline Mask less(DoubleDouble a, DoubleDouble b) {
    return less((a - b).high, Real::of(0));
}
[[gnu::always_inline]] inline DoubleDouble select(Mask m, DoubleDouble a, DoubleDouble b) {
    return {select(m, a.high, b.high), select(m, a.low, b.low)};
}
inline double at(DoubleDouble x, int lane) {
    return at(x.high, lane);
}
inline void put(DoubleDouble& x, int lane, double value) {
    put(x.high, lane, value);
    put(x.low, lane, 0);
}

/// About 48 decimal digits: the unevaluated sum of three numbers in each lane, each about as small
/// as the rounding error of the one before (after N. Fabiano, J.-M. Muller, J. Picot, IEEE Trans.
/// Comput. 68, 2019).
struct TripleDouble {
    static constexpr int width = Real::width;
    Real high, middle, low;
    static TripleDouble of(double x) { return {Real::of(x), Real::of(0), Real::of(0)}; }
    void store(double* x) const { high.store(x); }
};
/// a + b + c, where none is much larger than the one before.
[[gnu::always_inline]] inline TripleDouble renormalized(Real a, Real b, Real c) {
    const DoubleDouble tail = exact_sum(b, c), head = exact_sum(a, tail.high);
    const DoubleDouble rest = exact_sum(head.low, tail.low);
    return {head.high, rest.high, rest.low};
}
[[gnu::always_inline]] inline TripleDouble negative(TripleDouble a) {
    const Real zero = Real::of(0);
    return {zero - a.high, zero - a.middle, zero - a.low};
}
[[gnu::always_inline]] inline TripleDouble operator+(const TripleDouble& a, const TripleDouble& b) {
    const DoubleDouble high = exact_sum(a.high, b.high), middle = exact_sum(a.middle, b.middle);
    const DoubleDouble between = exact_sum(middle.high, high.low);
    return renormalized(high.high, between.high, (a.low + b.low) + (middle.low + between.low));
}
[[gnu::always_inline]] inline TripleDouble operator-(const TripleDouble& a, const TripleDouble& b) {
    return a + negative(b);
}
// The large ones are calls: inlined everywhere they would take the compiler minutes.
[[gnu::noinline]] inline TripleDouble operator*(const TripleDouble& a, const TripleDouble& b) {
    const Real zero = Real::of(0);
    const Real high = a.high * b.high, error = rounding_error(a.high, b.high, high);
    const Real across = a.high * b.middle, error_across = rounding_error(a.high, b.middle, across);
    const Real back = a.middle * b.high, error_back = rounding_error(a.middle, b.high, back);
    const DoubleDouble crossed = exact_sum(across, back);
    const DoubleDouble middle = exact_sum(crossed.high, zero - error);
    const Real low = fma(a.high, b.low, fma(a.low, b.high, a.middle * b.middle));
    const Real rest = (crossed.low + middle.low) - (error_across + error_back);
    return renormalized(high, middle.high, low + rest);
}
[[gnu::noinline]] inline TripleDouble operator/(TripleDouble a, const TripleDouble& b) {
    const Real zero = Real::of(0);
    Real digits[3];
    for (Real& digit : digits) {
        digit = a.high / b.high;
        a = a - b * TripleDouble{digit, zero, zero};
    }
    return renormalized(digits[0], digits[1], digits[2]);
}
[[gnu::noinline]] inline TripleDouble fma(const TripleDouble& a, const TripleDouble& b,
                                          const TripleDouble& c) {
    return a * b + c;
}
[[gnu::noinline]] inline TripleDouble fnma(const TripleDouble& a, const TripleDouble& b,
                                           const TripleDouble& c) {
    return c - a * b;
}
/// Only as accurate as Real's: enough for the sizes of steps.
[[gnu::always_inline]] inline TripleDouble sqrt(TripleDouble a) {
    return {sqrt(a.high), Real::of(0), Real::of(0)};
}
[[gnu::always_inline]] inline Mask less(TripleDouble a, TripleDouble b) {
    return less((a - b).high, Real::of(0));
}
[[gnu::always_inline]] inline TripleDouble select(Mask m, TripleDouble a, TripleDouble b) {
    return {select(m, a.high, b.high), select(m, a.middle, b.middle), select(m, a.low, b.low)};
}
inline double at(TripleDouble x, int lane) {
    return at(x.high, lane);
}
inline void put(TripleDouble& x, int lane, double value) {
    put(x.high, lane, value);
    put(x.middle, lane, 0);
    put(x.low, lane, 0);
}

} // namespace plprove::PLC_LANES
