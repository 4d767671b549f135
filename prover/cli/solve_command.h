// `plprove solve` and `plprove start`.
#pragma once

#include "prover/cli/command.h"

namespace plprove {

Command add_solve_command(CLI::App& program, const Deliver& deliver);
Command add_start_command(CLI::App& program, const Deliver& deliver);

} // namespace plprove
