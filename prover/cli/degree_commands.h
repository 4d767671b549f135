// The subcommands `plprove degree` and `plprove degrees`.
#pragma once

#include "prover/cli/command.h"
#include "prover/degree_sweep/sweep.h"

namespace plprove {

/// Adds `degree PROBLEM` to `program`.
Command add_degree_command(CLI::App& program, Deliver deliver, ComputeDegree compute);

/// Adds `degrees -o DIR` to `program`.
Command add_degrees_command(CLI::App& program, ComputeDegree compute);

} // namespace plprove
