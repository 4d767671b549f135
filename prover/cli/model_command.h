// `plprove model`: any problem that is given by equations.
#pragma once

#include "prover/cli/command.h"

namespace plprove {

/// Adds the subcommand to `program`. It writes files through `deliver`.
Command add_model_command(CLI::App& program, Deliver deliver);

} // namespace plprove
