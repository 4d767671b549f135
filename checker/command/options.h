// What a command line asks for.
#pragma once

#include "checker/command/expected.h"

#include <span>

namespace checker {
struct Options {
    bool json = false;                               // else text; then the next four do not matter
    bool quiet = false;                              // the last line only
    bool table = false, errata = false, why = false; // details
    std::size_t threads = 0;                         // that replay a file
    std::uint64_t effort = usual_effort;             // that a file may take
    Expectation expectation{};
    std::vector<const char*> paths{};
};

/// Options come before the files; `--` ends them. Throws WrongUsage.
Options parse_options(std::span<char* const> arguments);
} // namespace checker
