// `plprove template`.
#pragma once

#include "prover/cli/command.h"

namespace plprove {

Command add_template_command(CLI::App& program, Deliver deliver);

} // namespace plprove
