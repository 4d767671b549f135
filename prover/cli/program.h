// plprove as a function.
#pragma once

#include "prover/degree_sweep/sweep.h"

namespace plprove {

/// What the command line asks for; the result is the exit status. `compute` is the engine of the
/// commands `degree` and `degrees`.
int run_plprove(int argc, char** argv, const ComputeDegree& compute);

} // namespace plprove
