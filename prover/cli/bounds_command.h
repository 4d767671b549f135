// The subcommand `plprove bounds`.
#pragma once

#include "prover/cli/command.h"

namespace plprove {

/// Adds `bounds` to `program`: templates that bound the camera-degrees of the extensions of the
/// five-point problem from above.
Command add_bounds_command(CLI::App& program, Deliver deliver);

} // namespace plprove
