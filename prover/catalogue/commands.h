// The subcommands `plprove list` and `plprove export`.
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

/// Adds `list [FILTER...]` to `program`.
Command add_list_command(CLI::App& program, Deliver deliver);

/// Adds `export [DATABASE] [--csv FILE] [--json FILE]` to `program`. At least one option or file is
/// required; options that others add to the subcommand count. `run` writes the files of this list
/// only, none if none of them was named.
Command add_export_command(CLI::App& program, Deliver deliver);

} // namespace plprove
