// The path tracker for the camera equations, with the lanes of the instruction set that the
// including file is compiled for; with twice or three times the digits if that file defines
// PLC_DOUBLE_DOUBLE or PLC_TRIPLE_DOUBLE.
//
// No function of the standard library is used here: see prover/tracking/lanes.h.
#pragma once

#include "prover/three_views/tracking/linear_solver.h"
#include "prover/tracking/tracker.h"

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

/// The camera equations of moving images, as a Tracker wants them.
class MovingEquations {
public:
    MovingEquations(const TrackedSystem& system, const TrackedImages& images)
        : system_(system), images_(images) {}

    struct History {
        explicit History(const MovingEquations&) {}
        Number point[3][n], speed[3][n];
    };
    struct Step {
        explicit Step(const MovingEquations&) {}
        Number point[n], speed[n];
    };

    static constexpr int unknowns() { return n; }

    template <bool Moving>
    Real correct(Real time, Step& step) {
        Number correction[n];
        Evaluator(system_, images_, step.point).evaluate<Moving>(time, equations_);
        if constexpr (Moving)
            solve(equations_, correction, step.speed);
        else
            solve(equations_, correction);
        const Real size = relative_size(correction, step.point);
        for (int k = 0; k < n; ++k)
            step.point[k] = step.point[k] + correction[k];
        return size;
    }

private:
    const TrackedSystem& system_;
    const TrackedImages& images_;
    Equations equations_;
};

} // namespace

#if defined(PLC_DOUBLE_DOUBLE)
TrackCost track_double_double(
#elif defined(PLC_TRIPLE_DOUBLE)
TrackCost track_triple_double(
#else
TrackCost track(
#endif
    const TrackedSystem& system, const TrackedImages& images, const TrackSettings& settings,
    std::size_t count, const CameraPoint* starts, CameraPoint* ends, TrackOutcome* outcomes) {
    MovingEquations equations(system, images);
    return Tracker<MovingEquations>(equations, settings, count,
                                    reinterpret_cast<const double*>(starts),
                                    reinterpret_cast<double*>(ends), outcomes)
        .run();
}

} // namespace plprove::PLC_LANES
