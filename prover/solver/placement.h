// Starts from which paths are short.
#pragma once

#include "prover/solver/start.h"

namespace plprove {

/// The same start at other images: of a few random ones, and those of `start`, the images from
/// which paths to synthetic scenes take the fewest steps. The same images for the same seed.
Start well_placed(Start start, std::uint64_t seed);

} // namespace plprove
