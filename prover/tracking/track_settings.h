// How a path tracker takes its steps, and what comes of a path, whatever the equations are.
#pragma once

#include <cstdint>

namespace plprove {

/// Sizes are relative to the point of the path; times run from 0 to 1. The defaults are for three
/// views.
struct TrackSettings {
    double prediction = 3e-3; ///< Newton's first correction that the step size aims at
    double contraction = 0.1; ///< the second correction is at most that much of the first ...
    double noise = 1e-6;      ///< ... or as small as rounding may make it
    double first_step = 0.01;
    double largest_step = 0.25;
    double smallest_step = 1e-9; ///< a path that wants a smaller one is lost
    int most_steps = 600;        ///< attempted; a path that needs more is lost
};

enum class TrackOutcome : std::uint8_t { arrived, stuck, endless };

/// What tracking a list of paths cost.
struct TrackCost {
    std::uint64_t steps = 0; ///< attempted; each evaluates the equations and their Jacobian twice
};

} // namespace plprove
