// Where the built programs and the certificates are, for tests of what users do.
#pragma once

#include "tests/support/program.h"
#include "tests/support/text.h"

inline const std::string plprove = PLPROVE;
inline const std::string plcheck = PLCHECK;
inline const std::string certs = SOURCE_DIR "/certs/";
