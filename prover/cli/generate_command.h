// `plprove generate`.
#pragma once

#include "prover/cli/command.h"

namespace plprove {

Command add_generate_command(CLI::App& program, Deliver deliver);

} // namespace plprove
