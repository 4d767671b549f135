// Where a path goes next, judged by where it has been; and how large a correction is.
//
// No function of the standard library is used here: see lanes.h.
#pragma once

#include "prover/degree/tracking/evaluation.h"
#include "prover/degree/tracking/step_control.h"

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

/// Where the paths are at the time `after` their newest points.
inline void predict(const History& h, Real after, Number* out) {
    const Extrapolation extrapolation(h.time, h.points, after);
    for (int k = 0; k < n; ++k)
        out[k] = extrapolation(h.point[0][k], h.point[1][k], h.point[2][k], h.speed[0][k],
                               h.speed[1][k], h.speed[2][k]);
}

} // namespace

} // namespace plprove::PLC_LANES
