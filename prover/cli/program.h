// plprove as a function.
#pragma once

#include "prover/degree_sweep/sweep.h"

#include <string>

namespace plprove {

/// What the command line asks for; the result is the exit status. `compute` is the engine of the
/// commands `degree` and `degrees`.
int run_plprove(int argc, char** argv, const ComputeDegree& compute);

/// The commands and options of plprove, as describe() writes them: for manual pages and completion.
std::string describe_plprove();

} // namespace plprove
