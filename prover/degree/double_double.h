// Real numbers with about 32 decimal digits, each the unevaluated sum of two doubles, with the
// interface of lanes.h and one lane (T. J. Dekker, Numer. Math. 18, 1971; Y. Hida, X. S. Li,
// D. H. Bailey, ARITH-15, 2001).
#pragma once

namespace plprove::double_double {

using Mask = bool;
inline bool any(Mask m) {
    return m;
}
inline bool get(Mask m, int) {
    return m;
}
inline Mask both(Mask a, Mask b) {
    return a && b;
}
inline Mask either(Mask a, Mask b) {
    return a || b;
}
inline Mask without(Mask a, Mask b) {
    return a && !b;
}

struct Real {
    static constexpr int width = 1;
    using Flags = Mask;
    double high = 0, low = 0;
    static Real of(double x) { return {x, 0}; }
    static Real load(const double* x) { return {*x, 0}; }
    void store(double* x) const { *x = high; }
};

/// a + b exactly, if |a| >= |b|; and for any a, b.
inline Real quick_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}
inline Real exact_sum(double a, double b) {
    const double sum = a + b, part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}
inline Real exact_product(double a, double b) {
    const double product = a * b;
    return {product, __builtin_fma(a, b, -product)};
}

inline Real operator+(Real a, Real b) {
    Real high = exact_sum(a.high, b.high);
    const Real low = exact_sum(a.low, b.low);
    high = quick_sum(high.high, high.low + low.high);
    return quick_sum(high.high, high.low + low.low);
}
inline Real operator-(Real a, Real b) {
    return a + Real{-b.high, -b.low};
}
inline Real operator*(Real a, Real b) {
    const Real p = exact_product(a.high, b.high);
    return quick_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}
inline Real operator/(Real a, Real b) {
    const double first = a.high / b.high;
    Real rest = a - b * Real::of(first);
    const double second = rest.high / b.high;
    rest = rest - b * Real::of(second);
    const double third = rest.high / b.high;
    return quick_sum(first, second) + Real::of(third);
}
inline Real fma(Real a, Real b, Real c) {
    return a * b + c;
}
inline Real fnma(Real a, Real b, Real c) {
    return c - a * b;
}
inline Real sqrt(Real a) {
    if (!(a.high > 0)) return {__builtin_sqrt(a.high), 0};
    const double root = __builtin_sqrt(a.high);
    const Real error = a - exact_product(root, root);
    return quick_sum(root, error.high / (2 * root));
}
inline Mask less(Real a, Real b) {
    return a.high < b.high || (a.high == b.high && a.low < b.low);
}
inline Real select(Mask m, Real a, Real b) {
    return m ? a : b;
}

} // namespace plprove::double_double
