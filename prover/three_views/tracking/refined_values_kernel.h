// The values of the camera equations at precise zeros, many at a time, one in each lane, with about
// 32 digits.
//
// No function of the standard library is used here: see prover/tracking/lanes.h.
#pragma once

#define PLC_DOUBLE_DOUBLE
#include "prover/three_views/tracking/tracker_kernel.h"

namespace plprove::PLC_LANES {

namespace {

/// At most one zero for each lane; values[zero][equation].
inline void refined_values_of_block(const TrackedSystem& system, const TrackedImages& images,
                                    const TrackedImages& others, std::size_t count,
                                    const CameraPoint* zeros, Complex* values) {
    constexpr int newton_steps = 4; // from a double to twice the digits
    Number point[n], correction[n];
    for (int k = 0; k < n; ++k)
        for (int lane = 0; lane < Real::width; ++lane) {
            const auto i = static_cast<std::size_t>(lane);
            const double* z = reinterpret_cast<const double*>(&zeros[i < count ? i : 0]) + 2 * k;
            put(point[k].re, lane, z[0]);
            put(point[k].im, lane, z[1]);
        }
    Equations equations;
    for (int step = 0; step < newton_steps; ++step) {
        Evaluator(system, images, point).evaluate<false>(Real::of(0), equations);
        solve(equations, correction);
        for (int k = 0; k < n; ++k)
            point[k] = point[k] + correction[k];
    }
    Evaluator(system, others, point).evaluate<false>(Real::of(0), equations);
    for (std::size_t i = 0; i < count; ++i)
        for (int e = 0; e < n; ++e) {
            double* value = reinterpret_cast<double*>(&values[i * n + static_cast<std::size_t>(e)]);
            value[0] = at(equations.entry[e][n].re, static_cast<int>(i));
            value[1] = at(equations.entry[e][n].im, static_cast<int>(i));
        }
}

} // namespace

void refined_values(const TrackedSystem& system, const TrackedImages& images,
                    const TrackedImages& others, std::size_t count, const CameraPoint* zeros,
                    Complex* values) {
    constexpr std::size_t width = DoubleDouble::width;
    for (std::size_t i = 0; i < count; i += width)
        refined_values_of_block(system, images, others, count - i < width ? count - i : width,
                                zeros + i, values + i * n);
}

} // namespace plprove::PLC_LANES
