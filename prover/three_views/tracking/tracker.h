// Path tracking: follows solutions of the camera equations while the images move.
#pragma once

#include "prover/three_views/camera_system.h"
#include "prover/tracking/track_settings.h"

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

/// Follows each start to t = 1; starts and ends are arrays of `count` points, outcomes as well.
using TrackFunction = TrackCost(const TrackedSystem& system, const TrackedImages& images,
                                const TrackSettings& settings, std::size_t count,
                                const CameraPoint* starts, CameraPoint* ends,
                                TrackOutcome* outcomes);

/// The same, where each path has images of its own: an array of `count`.
using TrackEachFunction = TrackCost(const TrackedSystem& system, const TrackedImages* images,
                                    const TrackSettings& settings, std::size_t count,
                                    const CameraPoint* starts, CameraPoint* ends,
                                    TrackOutcome* outcomes);

/// Computes values[zero][equation], at images at rest: the zeros of these are approximate, and made
/// precise to about 32 digits first; the values are those for `others`.
using RefinedValuesFunction = void(const TrackedSystem& system, const TrackedImages& images,
                                   const TrackedImages& others, std::size_t count,
                                   const CameraPoint* zeros, Complex* values);

namespace avx512 {
TrackFunction track, track_double_double, track_triple_double;
TrackEachFunction track_each;
RefinedValuesFunction refined_values;
} // namespace avx512
namespace avx2 {
TrackFunction track, track_double_double, track_triple_double;
TrackEachFunction track_each;
RefinedValuesFunction refined_values;
} // namespace avx2
namespace portable {
TrackFunction track, track_double_double, track_triple_double;
TrackEachFunction track_each;
RefinedValuesFunction refined_values;
} // namespace portable

/// The one with most lanes that this machine can run. All give the same results, to the bit.
TrackFunction* fastest_tracker();
/// The same for images of each path's own.
TrackEachFunction* fastest_tracker_of_each();
/// fastest_tracker(), with about 32 digits throughout, some ten times as slow; starts and ends are
/// doubles.
TrackFunction* fastest_double_double_tracker();
/// The same, with about 48 digits; a few times as slow again.
TrackFunction* fastest_triple_double_tracker();
/// The values at precise zeros with the most lanes.
RefinedValuesFunction* fastest_refined_values();

} // namespace plprove
