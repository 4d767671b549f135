// Where a path goes next, judged by where it has been; and how large a correction is.
//
// No function of the standard library is used here: see lanes.h.
#pragma once

#include "prover/degree/tracking/evaluation.h"

namespace plprove::PLC_LANES {

namespace {

/// The relative size, squared, of a correction: the largest of those of the two quaternions and the
/// centres, where the coordinate that the chart fixes counts as 1.
inline Real relative_size(const Number* correction, const Number* point) {
    const Real one = Real::of(1);
    const int begin[4] = {0, 3, 6, n};
    Real result = Real::of(0);
    for (int block = 0; block < 3; ++block) {
        Real change = Real::of(0), norm = one;
        for (int k = begin[block]; k < begin[block + 1]; ++k) {
            change = change + square(correction[k]);
            norm = norm + square(point[k]);
        }
        result = larger(result, change / norm);
    }
    return result;
}

/// The last three points of each path with their speeds, the newest first.
struct History {
    Number point[3][n];
    Number speed[3][n];
    Real time[3];
    Real points; ///< how many of them there are
};

/// Hermite extrapolation (Newton's form, each node twice) to the time `after` the newest point.
inline void predict(const History& h, Real after, Number* out) {
    const Real a = h.time[0] - h.time[1], b = h.time[0] - h.time[2], c = h.time[1] - h.time[2];
    const Real one = Real::of(1), zero = Real::of(0);
    const Real by_a = one / a, by_b = one / b, by_c = one / c;
    const Mask two = less(Real::of(1.5), h.points), three = less(Real::of(2.5), h.points);
    const Real s = after, ss = s * s, sa = s + a;
    const Real w3 = ss * sa, w4 = w3 * sa, w5 = w4 * (s + b);
    for (int k = 0; k < n; ++k) {
        const auto part = [&](auto member) {
            const Real x0 = member(h.point[0][k]), x1 = member(h.point[1][k]),
                       x2 = member(h.point[2][k]);
            const Real v0 = member(h.speed[0][k]), v1 = member(h.speed[1][k]),
                       v2 = member(h.speed[2][k]);
            const Real d01 = (x0 - x1) * by_a, d12 = (x1 - x2) * by_c;
            const Real d001 = (v0 - d01) * by_a, d011 = (d01 - v1) * by_a;
            const Real d112 = (v1 - d12) * by_c, d122 = (d12 - v2) * by_c;
            const Real d0011 = (d001 - d011) * by_a, d0112 = (d011 - d112) * by_b,
                       d1122 = (d112 - d122) * by_c;
            const Real d00112 = (d0011 - d0112) * by_b, d01122 = (d0112 - d1122) * by_b;
            const Real d001122 = (d00112 - d01122) * by_b;
            Real sum = fma(s, v0, x0);
            sum = fma(ss, select(two, d001, zero), sum);
            sum = fma(w3, select(two, d0011, zero), sum);
            sum = fma(w4, select(three, d00112, zero), sum);
            return fma(w5, select(three, d001122, zero), sum);
        };
        out[k] = {part([](Number x) { return x.re; }), part([](Number x) { return x.im; })};
    }
}

} // namespace

} // namespace plprove::PLC_LANES
