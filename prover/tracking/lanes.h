// Real numbers for the path tracker, several paths at a time: one number per path ("lane"), added,
// multiplied and compared lane by lane. The width is that of the instruction set which a file is
// compiled for. Every operation is the correctly rounded one of IEEE 754, fused where it says fma,
// so that each lane computes the same bits whatever the width. WebAssembly alone fuses nothing: its
// fma rounds twice.
//
// A file that includes this may use inline functions of the standard library only with care: the
// linker keeps one copy of them, which must not contain instructions that the machine lacks.
//
// A loop marked PLC_UNROLLED is unrolled where there are vectors: a column of the matrix then fits
// into the registers.
#pragma once

#if defined(__AVX512F__)
#include <immintrin.h>
#define PLC_LANES avx512
#define PLC_UNROLLED _Pragma("GCC unroll 16")
#elif defined(__AVX2__) && defined(__FMA__)
#include <immintrin.h>
#define PLC_LANES avx2
#define PLC_UNROLLED _Pragma("GCC unroll 16")
#else
#if defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif
#define PLC_LANES portable
#define PLC_UNROLLED
#endif

namespace plprove::PLC_LANES {

#if defined(__AVX512F__)

using Mask = __mmask8;
inline bool any(Mask m) {
    return m != 0;
}
inline bool get(Mask m, int lane) {
    return (m >> lane & 1) != 0;
}
inline Mask both(Mask a, Mask b) {
    return a & b;
}
inline Mask either(Mask a, Mask b) {
    return a | b;
}
inline Mask without(Mask a, Mask b) {
    return static_cast<Mask>(a & ~b);
}

struct Real {
    static constexpr int width = 8;
    __m512d v;
    static Real of(double x) { return {_mm512_set1_pd(x)}; }
    static Real load(const double* x) { return {_mm512_loadu_pd(x)}; }
    void store(double* x) const { _mm512_storeu_pd(x, v); }
};
inline Real operator+(Real a, Real b) {
    return {_mm512_add_pd(a.v, b.v)};
}
inline Real operator-(Real a, Real b) {
    return {_mm512_sub_pd(a.v, b.v)};
}
inline Real operator*(Real a, Real b) {
    return {_mm512_mul_pd(a.v, b.v)};
}
inline Real operator/(Real a, Real b) {
    return {_mm512_div_pd(a.v, b.v)};
}
inline Real fma(Real a, Real b, Real c) {
    return {_mm512_fmadd_pd(a.v, b.v, c.v)};
}
inline Real fnma(Real a, Real b, Real c) {
    return {_mm512_fnmadd_pd(a.v, b.v, c.v)};
}
inline Real sqrt(Real a) {
    return {_mm512_maskz_sqrt_pd(0xff, a.v)};
}
inline Mask less(Real a, Real b) {
    return _mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ);
}
inline Real select(Mask m, Real a, Real b) {
    return {_mm512_mask_blend_pd(m, b.v, a.v)};
}

#elif defined(__AVX2__) && defined(__FMA__)

struct Mask {
    __m256d v;
};
inline bool any(Mask m) {
    return _mm256_movemask_pd(m.v) != 0;
}
inline bool get(Mask m, int lane) {
    return (_mm256_movemask_pd(m.v) >> lane & 1) != 0;
}
inline Mask both(Mask a, Mask b) {
    return {_mm256_and_pd(a.v, b.v)};
}
inline Mask either(Mask a, Mask b) {
    return {_mm256_or_pd(a.v, b.v)};
}
inline Mask without(Mask a, Mask b) {
    return {_mm256_andnot_pd(b.v, a.v)};
}

struct Real {
    static constexpr int width = 4;
    __m256d v;
    static Real of(double x) { return {_mm256_set1_pd(x)}; }
    static Real load(const double* x) { return {_mm256_loadu_pd(x)}; }
    void store(double* x) const { _mm256_storeu_pd(x, v); }
};
inline Real operator+(Real a, Real b) {
    return {_mm256_add_pd(a.v, b.v)};
}
inline Real operator-(Real a, Real b) {
    return {_mm256_sub_pd(a.v, b.v)};
}
inline Real operator*(Real a, Real b) {
    return {_mm256_mul_pd(a.v, b.v)};
}
inline Real operator/(Real a, Real b) {
    return {_mm256_div_pd(a.v, b.v)};
}
inline Real fma(Real a, Real b, Real c) {
    return {_mm256_fmadd_pd(a.v, b.v, c.v)};
}
inline Real fnma(Real a, Real b, Real c) {
    return {_mm256_fnmadd_pd(a.v, b.v, c.v)};
}
inline Real sqrt(Real a) {
    return {_mm256_sqrt_pd(a.v)};
}
inline Mask less(Real a, Real b) {
    return {_mm256_cmp_pd(a.v, b.v, _CMP_LT_OQ)};
}
inline Real select(Mask m, Real a, Real b) {
    return {_mm256_blendv_pd(b.v, a.v, m.v)};
}

#elif defined(__wasm_simd128__)

struct Mask {
    v128_t v;
};
inline bool any(Mask m) {
    return wasm_v128_any_true(m.v);
}
inline bool get(Mask m, int lane) {
    return (wasm_i64x2_bitmask(m.v) >> lane & 1) != 0;
}
inline Mask both(Mask a, Mask b) {
    return {wasm_v128_and(a.v, b.v)};
}
inline Mask either(Mask a, Mask b) {
    return {wasm_v128_or(a.v, b.v)};
}
inline Mask without(Mask a, Mask b) {
    return {wasm_v128_andnot(a.v, b.v)};
}

struct Real {
    static constexpr int width = 2;
    v128_t v;
    static Real of(double x) { return {wasm_f64x2_splat(x)}; }
    static Real load(const double* x) { return {wasm_v128_load(x)}; }
    void store(double* x) const { wasm_v128_store(x, v); }
};
inline Real operator+(Real a, Real b) {
    return {wasm_f64x2_add(a.v, b.v)};
}
inline Real operator-(Real a, Real b) {
    return {wasm_f64x2_sub(a.v, b.v)};
}
inline Real operator*(Real a, Real b) {
    return {wasm_f64x2_mul(a.v, b.v)};
}
inline Real operator/(Real a, Real b) {
    return {wasm_f64x2_div(a.v, b.v)};
}
inline Real fma(Real a, Real b, Real c) {
    return a * b + c;
}
inline Real fnma(Real a, Real b, Real c) {
    return c - a * b;
}
inline Real sqrt(Real a) {
    return {wasm_f64x2_sqrt(a.v)};
}
inline Mask less(Real a, Real b) {
    return {wasm_f64x2_lt(a.v, b.v)};
}
inline Real select(Mask m, Real a, Real b) {
    return {wasm_v128_bitselect(a.v, b.v, m.v)};
}

#else

/// One path at a time, on any machine.
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
    double v;
    static Real of(double x) { return {x}; }
    static Real load(const double* x) { return {*x}; }
    void store(double* x) const { *x = v; }
};
inline Real operator+(Real a, Real b) {
    return {a.v + b.v};
}
inline Real operator-(Real a, Real b) {
    return {a.v - b.v};
}
inline Real operator*(Real a, Real b) {
    return {a.v * b.v};
}
inline Real operator/(Real a, Real b) {
    return {a.v / b.v};
}
inline Real fma(Real a, Real b, Real c) {
    return {__builtin_fma(a.v, b.v, c.v)};
}
inline Real fnma(Real a, Real b, Real c) {
    return {__builtin_fma(-a.v, b.v, c.v)};
}
inline Real sqrt(Real a) {
    return {__builtin_sqrt(a.v)};
}
inline Mask less(Real a, Real b) {
    return a.v < b.v;
}
inline Real select(Mask m, Real a, Real b) {
    return m ? a : b;
}

#endif

/// product - a b, where the product is a b rounded: exactly, but where it underflows or, without
/// fused operations, a factor is larger than 1e300.
inline Real rounding_error(Real a, Real b, Real product) {
#if defined(__wasm_simd128__)
    // In halves of the digits, whose products are exact (T. J. Dekker, Numer. Math. 18, 1971).
    const Real splitter = Real::of(134217729); // 2^27 + 1
    const Real wide_a = splitter * a, wide_b = splitter * b;
    const Real a1 = wide_a - (wide_a - a), a2 = a - a1;
    const Real b1 = wide_b - (wide_b - b), b2 = b - b1;
    return (((product - a1 * b1) - a1 * b2) - a2 * b1) - a2 * b2;
#else
    return fnma(a, b, product);
#endif
}

/// The number in one lane.
inline double at(Real x, int lane) {
    double lanes[Real::width];
    x.store(lanes);
    return lanes[lane];
}
inline void put(Real& x, int lane, double value) {
    double lanes[Real::width];
    x.store(lanes);
    lanes[lane] = value;
    x = Real::load(lanes);
}

} // namespace plprove::PLC_LANES
