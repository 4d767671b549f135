// The subcommand `plprove group`.
#pragma once

#include "prover/cli/command.h"

namespace plprove {

/// Adds `group PROBLEM` to `program`.
Command add_group_command(CLI::App& program, Deliver deliver);

} // namespace plprove
