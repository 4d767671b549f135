// `plprove recommend`.
#pragma once

#include "prover/cli/command.h"

namespace plprove {

Command add_recommend_command(CLI::App& program, const Deliver& deliver);

} // namespace plprove
