// A subcommand of plprove.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace plprove {

/// Writes a text to a file, or to standard output for the name "-"; throws std::system_error.
using Deliver = std::function<void(const std::string& path, const std::string& text)>;

/// A subcommand, and what to do once it was chosen: the result is the exit status of the program.
struct Command {
    CLI::App* app;
    std::function<int()> run;
};

} // namespace plprove
