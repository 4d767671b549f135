// Real numbers for the path tracker, several paths at a time: one number per path ("lane"), added,
// multiplied and compared lane by lane. The width is that of the instruction set which a file is
// compiled for. Every operation is the correctly rounded one of IEEE 754, fused where it says fma,
// so that each lane computes the same bits whatever the width.
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
