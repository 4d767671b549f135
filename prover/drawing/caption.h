// The notation of a problem broken into lines, for captions.
#pragma once

#include "prover/problem/notation.h"

#include <string>
#include <vector>

namespace plprove {

/// The notation in lines of at most `columns` characters where its summands allow it: a line breaks
/// before a `+` only.
std::vector<std::string> caption(const Features& problem, std::size_t columns);

/// What a problem consists of, in words: `3 points, 2 pins and 1 free line in 3 views`.
std::string describe(const Features& problem);

} // namespace plprove
