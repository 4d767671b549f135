// Terminal problems (Theorem 6 and Definition 8 of the paper): camera-minimal problems in which
// every image of a pin that puts no condition on the cameras is taken away. They are not always
// minimal: their dangling pins, seen in one view only, are not determined.
#pragma once

#include "prover/problem/signature.h"

#include <string>

namespace plprove {

/// The terminal form of one of the 27 features. Where some view sees a pin but not its point, and
/// no further view is told anything by the pin, the views that see the point forget it: P/Pa/a
/// becomes P/P/a, Pab/b/a becomes P/b/a (features 12 to 17 and 24 to 26). Every other feature stays
/// as it is.
Feature terminal_form(const Feature& feature);

/// The terminal problem that a reduced problem with this signature becomes: the same for the two
/// features of a swap pair. For a problem that is not minimal the result is not camera-minimal, so
/// it is no terminal problem.
std::string terminal_notation(const Signature& signature);

/// The notation of problem_of(signature), from the signature alone.
std::string notation(const Signature& signature);

} // namespace plprove
