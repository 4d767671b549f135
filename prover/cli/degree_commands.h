// The subcommand `plprove degree`.
#pragma once

#include "prover/cli/command.h"
#include "prover/degree_sweep/sweep.h"

namespace plprove {

/// Adds `degree PROBLEM` to `program`.
Command add_degree_command(CLI::App& program, Deliver deliver, ComputeDegree compute);

} // namespace plprove
