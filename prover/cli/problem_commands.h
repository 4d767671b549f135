// The subcommands that answer about one problem: `plprove problem`, `certify` and `show`.
#pragma once

#include "prover/cli/command.h"

namespace plprove {

/// Adds `problem PROBLEM` to `program`: the verdict, and what is known.
Command add_problem_command(CLI::App& program, Deliver deliver);

/// Adds `certify PROBLEM`: the certificate of the verdict.
Command add_certify_command(CLI::App& program, Deliver deliver);

/// Adds `show PROBLEM`: pictures.
Command add_show_command(CLI::App& program, Deliver deliver);

} // namespace plprove
