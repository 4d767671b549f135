// The project as `cmake --install` leaves it.
#pragma once

#include "tests/support/program.h"

/// The prefix of an installation that the tests of this program share; it vanishes at the end.
const std::filesystem::path& installed();

/// Whether this machine has the program.
bool has_program(const std::string& name);
