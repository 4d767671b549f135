// The commands of sweeps: `plprove degrees`, the degrees of many classes or problems by threads and
// by ranks of MPI, and `plprove collect`, the files that a sweep's folder gives.
#pragma once

#include "prover/cli/command.h"
#include "prover/degree_sweep/sweep.h"

namespace plprove {

/// Adds `degrees -o DIR` to `program`; `compute` is the engine for classes.
Command add_degrees_command(CLI::App& program, ComputeDegree compute);

/// Adds `collect -o DIR` to `program`.
Command add_collect_command(CLI::App& program);

} // namespace plprove
