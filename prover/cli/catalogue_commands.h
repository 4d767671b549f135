// The subcommands `plprove list` and `plprove export`.
#pragma once

#include "prover/cli/command.h"

namespace plprove {

/// Adds `list [FILTER...]` to `program`.
Command add_list_command(CLI::App& program, Deliver deliver);

/// Adds `export [DATABASE] [--csv FILE] [--json FILE]` to `program`. At least one option or file is
/// required; options that others add to the subcommand count. `run` writes the files of this list
/// only, none if none of them was named.
Command add_export_command(CLI::App& program, Deliver deliver);

} // namespace plprove
