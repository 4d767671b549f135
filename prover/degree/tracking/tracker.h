// Path tracking: follows solutions of the camera equations while the images move.
#pragma once

#include "prover/degree/camera_system.h"
#include "prover/degree/tracking/track_settings.h"

#include <cstddef>
#include <cstdint>

namespace plprove {

/// Each of the 11 equations has at most three image vectors.
inline constexpr int max_vectors = 33;

/// A CameraSystem with its chart, in plain arrays for the inner loops.
struct TrackedSystem {
    struct Equation {
        EquationKind kind;
        int vectors[3];
        int views[3]; ///< of the vectors
    };
    int vectors = 0;
    int views[max_vectors] = {};
    Equation equations[camera_dimension] = {};
    double rotation[2][3][2] = {}; ///< the chart, real and imaginary parts
    double centre[5][2] = {};
};

/// Images that move with time t from 0 to 1: each image vector is a quadratic polynomial in t.
struct TrackedImages {
    double coefficient[max_vectors][3][3][2]; ///< [vector][coordinate][power of t][re, im]
};

enum class TrackOutcome : std::uint8_t { arrived, stuck, endless };

/// What tracking a list of paths cost.
struct TrackCost {
    std::uint64_t steps = 0; ///< attempted; each evaluates the equations and their Jacobian twice
};

/// Follows each start to t = 1; starts and ends are arrays of `count` points, outcomes as well.
using TrackFunction = TrackCost(const TrackedSystem& system, const TrackedImages& images,
                                const TrackSettings& settings, std::size_t count,
                                const CameraPoint* starts, CameraPoint* ends,
                                TrackOutcome* outcomes);

/// A line p + s m of images of a vector p, and another direction m' (trace_test.h).
struct TracePencil {
    int equation = 0;                ///< the only one that p is in
    TrackedImages along;             ///< p + s m, where the time is s
    TrackedImages direction, across; ///< m and m' in the place of p, at rest
};

/// phi = G(m') / G(m) at a solution, to the second power of s: constant + linear s + quadratic s^2.
struct TraceTerm {
    Complex constant, linear, quadratic;
};

/// Computes terms[solution][pencil] from approximate solutions, with about 32 digits.
using TraceFunction = void(const TrackedSystem& system, const TracePencil* pencils,
                           std::size_t pencil_count, std::size_t count,
                           const CameraPoint* solutions, TraceTerm* terms);

namespace avx512 {
TrackFunction track, track_double_double, track_triple_double;
TraceFunction trace_terms;
} // namespace avx512
namespace avx2 {
TrackFunction track, track_double_double, track_triple_double;
TraceFunction trace_terms;
} // namespace avx2
namespace portable {
TrackFunction track, track_double_double, track_triple_double;
TraceFunction trace_terms;
} // namespace portable

/// The one with most lanes that this machine can run. All give the same results, to the bit.
TrackFunction* fastest_tracker();
/// The same, with about 32 digits throughout, some ten times as slow; starts and ends are
/// doubles.
TrackFunction* fastest_double_double_tracker();
/// The same, with about 48 digits; a few times as slow again.
TrackFunction* fastest_triple_double_tracker();
/// The terms of the trace test with the most lanes.
TraceFunction* fastest_trace();

} // namespace plprove
