// The subcommand `plprove degrees`: the degrees of many classes, by threads and by ranks of MPI.
#pragma once

#include "prover/cli/command.h"
#include "prover/degree_sweep/sweep.h"

namespace plprove {

/// Adds `degrees -o DIR` to `program`.
Command add_degrees_command(CLI::App& program, ComputeDegree compute);

} // namespace plprove
