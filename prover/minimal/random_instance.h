// Points at which a problem is tried: nobody chose them.
#pragma once

#include "prover/minimal/jacobian.h"

namespace plprove {

/// The largest coordinate by which a place stands for a generic one.
inline constexpr std::int64_t most_coordinate = 999999;

/// Cameras and a scene with random integer coordinates of at most this size; the same for a seed on
/// every machine.
Instance random_instance(const Problem& problem, unsigned seed, std::int64_t largest);

} // namespace plprove
