// A stand-in for the engine of degrees, quick and without mathematics: what it says of a class and
// of its certificate is well-formed, always the same, and not true.
#pragma once

#include "prover/three_views/degree.h"

namespace fake_engine {

/// What compute() says of the class if no target stops it.
int degree(std::size_t number);

/// Whether it fails for the class: throws, or falls short of all targets.
bool throws(std::size_t number);
bool falls_short(std::size_t number);

plprove::DegreeRun compute(std::size_t number, const plprove::DegreeOptions& options);

} // namespace fake_engine
