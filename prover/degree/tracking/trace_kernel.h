// The terms of the trace test (trace_test.h) of many solutions at a time, one in each lane, with
// about 32 digits: what a solution adds may be a millionth of what a nearly singular one adds.
//
// No function of the standard library is used here: see lanes.h.
#pragma once

#define PLC_DOUBLE_DOUBLE
#include "prover/degree/tracking/tracker_kernel.h"

namespace plprove::PLC_LANES {

namespace {

/// A power series in the parameter s of a pencil, up to its second power.
struct Series {
    Real c[3];
    static Series of(double x) { return {{Real::of(x), Real::of(0), Real::of(0)}}; }
};
inline Series operator+(const Series& a, const Series& b) {
    return {{a.c[0] + b.c[0], a.c[1] + b.c[1], a.c[2] + b.c[2]}};
}
inline Series operator-(const Series& a, const Series& b) {
    return {{a.c[0] - b.c[0], a.c[1] - b.c[1], a.c[2] - b.c[2]}};
}
inline Series operator*(const Series& a, const Series& b) {
    return {{a.c[0] * b.c[0], fma(a.c[0], b.c[1], a.c[1] * b.c[0]),
             fma(a.c[0], b.c[2], fma(a.c[1], b.c[1], a.c[2] * b.c[0]))}};
}
inline Series fma(const Series& a, const Series& b, const Series& c) {
    return a * b + c;
}
inline Series fnma(const Series& a, const Series& b, const Series& c) {
    return c - a * b;
}

inline Complexes<Series> series(Number a, Number b, Number c) {
    return {{{a.re, b.re, c.re}}, {{a.im, b.im, c.im}}};
}
inline Number coefficient(const Complexes<Series>& a, int power) {
    return {a.re.c[power], a.im.c[power]};
}

inline Number reciprocal(Number a) {
    const Real scale = Real::of(1) / square(a);
    return {a.re * scale, (Real::of(0) - a.im) * scale};
}

/// The left hand side of an equation.
template <class R>
Complexes<R> value(const TrackedSystem::Equation& equation, const TrackedImages& images,
                   const MovingCameras<R>& cameras, R time) {
    const int i = equation.views[0], j = equation.views[1], k = equation.views[2];
    Vectors<R> x[3];
    for (int m = 0; m < (equation.kind == EquationKind::epipolar ? 2 : 3); ++m)
        x[m] = cameras.back(equation.views[m], image_vector(images, equation.vectors[m], time));
    switch (equation.kind) {
    case EquationKind::epipolar:
        return dot(cameras.centre[j] - cameras.centre[i], cross(x[0], x[1]));
    case EquationKind::incidence:
        return subtract(dot(x[1], cameras.centre[i] - cameras.centre[j]) * dot(x[2], x[0]),
                        dot(x[2], cameras.centre[i] - cameras.centre[k]), dot(x[1], x[0]));
    default:
        return dot(x[0], cross(x[1], x[2]));
    }
}

class Tracer {
public:
    Tracer(const TrackedSystem& system, const TracePencil* pencils, std::size_t pencil_count)
        : system_(system), pencils_(pencils), pencil_count_(pencil_count) {}

    /// `count` solutions, at most as many as lanes; terms[solution][pencil].
    void block(std::size_t count, const CameraPoint* solutions, TraceTerm* terms) const {
        Number point[n];
        for (int k = 0; k < n; ++k)
            for (int lane = 0; lane < Real::width; ++lane) {
                const auto i = static_cast<std::size_t>(lane);
                const CameraPoint& solution = solutions[i < count ? i : 0];
                const double* z = reinterpret_cast<const double*>(&solution) + 2 * k;
                put(point[k].re, lane, z[0]);
                put(point[k].im, lane, z[1]);
            }
        refine(point);
        for (std::size_t p = 0; p < pencil_count_; ++p) {
            Number term[3];
            trace(pencils_[p], point, term);
            for (std::size_t i = 0; i < count; ++i) {
                const auto lane = static_cast<int>(i);
                const auto number = [&](const Number& z) {
                    return Complex(at(z.re, lane), at(z.im, lane));
                };
                terms[i * pencil_count_ + p] = {number(term[0]), number(term[1]), number(term[2])};
            }
        }
    }

private:
    /// Newton's method, from a double to twice as many digits.
    void refine(Number* point) const {
        Equations equations;
        Number correction[n];
        for (int step = 0; step < 4; ++step) {
            Evaluator(system_, pencils_[0].along, point).evaluate<false>(Real::of(0), equations);
            solve(equations, correction);
            for (int k = 0; k < n; ++k)
                point[k] = point[k] + correction[k];
        }
    }

    /// phi to the second power of s.
    void trace(const TracePencil& pencil, const Number* point, Number* phi) const {
        const Number zero{Real::of(0), Real::of(0)};
        const Series time{{Real::of(0), Real::of(1), Real::of(0)}};
        // x + s x1 + s^2 x2, from the powers of s in the equations.
        Equations equations, solved;
        Evaluator(system_, pencil.along, point).evaluate<true>(Real::of(0), equations);
        solved = equations;
        Number still[n], first[n], second[n];
        solve(solved, still, first);
        Complexes<Series> curve[n];
        for (int k = 0; k < n; ++k)
            curve[k] = series(point[k], first[k], zero);
        const MovingCameras<Series> tangent(system_, curve);
        for (int e = 0; e < n; ++e)
            equations.entry[e][n] =
                coefficient(value(system_.equations[e], pencil.along, tangent, time), 2);
        solve(equations, second);
        for (int k = 0; k < n; ++k)
            curve[k] = series(point[k], first[k], second[k]);
        const MovingCameras<Series> cameras(system_, curve);
        const TrackedSystem::Equation& equation = system_.equations[pencil.equation];
        const auto above = value(equation, pencil.across, cameras, Series::of(0));
        const auto below = value(equation, pencil.direction, cameras, Series::of(0));
        const Number inverse = reciprocal(coefficient(below, 0));
        phi[0] = coefficient(above, 0) * inverse;
        phi[1] = subtract(coefficient(above, 1), phi[0], coefficient(below, 1)) * inverse;
        phi[2] = subtract(subtract(coefficient(above, 2), phi[0], coefficient(below, 2)), phi[1],
                          coefficient(below, 1)) *
                 inverse;
    }

    const TrackedSystem& system_;
    const TracePencil* pencils_;
    std::size_t pencil_count_;
};

} // namespace

void trace_terms(const TrackedSystem& system, const TracePencil* pencils, std::size_t pencil_count,
                 std::size_t count, const CameraPoint* solutions, TraceTerm* terms) {
    constexpr std::size_t width = DoubleDouble::width;
    const Tracer tracer(system, pencils, pencil_count);
    for (std::size_t i = 0; i < count; i += width)
        tracer.block(count - i < width ? count - i : width, solutions + i,
                     terms + i * pencil_count);
}

} // namespace plprove::PLC_LANES
