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
template <class Images>
class MovingEquations {
public:
    MovingEquations(const TrackedSystem& system, const Images& images)
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
        Evaluator<Images>(system_, images_, step.point).template evaluate<Moving>(time, equations_);
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
    const Images& images_;
    Equations equations_;
};

#if !defined(PLC_DOUBLE_DOUBLE) && !defined(PLC_TRIPLE_DOUBLE)
/// The same, where each path has images of its own.
class EquationsOfPaths : public MovingEquations<LaneImages> {
public:
    EquationsOfPaths(const TrackedSystem& system, const TrackedImages* images)
        : MovingEquations(system, lanes_), vectors_(system.vectors), images_(images) {}

    void begin(int lane, std::size_t path) {
        for (int v = 0; v < vectors_; ++v)
            for (int k = 0; k < 3; ++k)
                for (int power = 0; power < 3; ++power) {
                    const double* c = images_[path].coefficient[v][k][power];
                    put(lanes_.coefficient[v][k][power].re, lane, c[0]);
                    put(lanes_.coefficient[v][k][power].im, lane, c[1]);
                }
    }

private:
    int vectors_;
    const TrackedImages* images_;
    LaneImages lanes_{};
};
#endif

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
    using System = MovingEquations<TrackedImages>;
    System equations(system, images);
    return Tracker<System>(equations, settings, count, reinterpret_cast<const double*>(starts),
                           reinterpret_cast<double*>(ends), outcomes)
        .run();
}

#if !defined(PLC_DOUBLE_DOUBLE) && !defined(PLC_TRIPLE_DOUBLE)
TrackCost track_each(const TrackedSystem& system, const TrackedImages* images,
                     const TrackSettings& settings, std::size_t count, const CameraPoint* starts,
                     CameraPoint* ends, TrackOutcome* outcomes) {
    EquationsOfPaths equations(system, images);
    return Tracker<EquationsOfPaths>(equations, settings, count,
                                     reinterpret_cast<const double*>(starts),
                                     reinterpret_cast<double*>(ends), outcomes)
        .run();
}
#endif

} // namespace plprove::PLC_LANES
