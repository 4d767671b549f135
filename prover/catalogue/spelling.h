// Reduced problems and their terminal problems spelled from signatures alone: 143,494 of them at
// once.
#pragma once

#include "prover/problem/signature.h"

#include <string>

namespace plprove {

/// The notation of problem_of(signature).
std::string notation(const Signature& signature);

/// The terminal problem that a minimal problem with this signature becomes (terminal() of
/// reduction.h, feature by feature), the features of a swap pair counted in one term. Where the
/// problem is not minimal, the result is not camera-minimal and so no terminal problem.
std::string terminal_notation(const Signature& signature);

} // namespace plprove
