// Encodings of problems by nested lists of numbers.
#pragma once

#include "prover/problem/problem.h"

namespace plprove {

/// A signature of 27 numbers, or the Macaulay2 encoding of the authors of the paper; see
/// parse_spec(). Throws NotationError.
Features read_list(std::string_view text);

/// PLMP's encoding, see parse_general_spec(). Throws NotationError.
Problem read_plmp(std::string_view text, const CameraModel& cameras);

} // namespace plprove
