// What the subcommands `problem`, `certify` and `list` do with problems in general.
#pragma once

#include "prover/cli/command.h"
#include "prover/minimal/problem_record.h"

namespace plprove {

/// The family with this name, which add_family_option allows.
const CameraModel& family_named(const std::string& name);

/// Certificates of all problems of the family; shows progress on a terminal.
std::vector<ProblemRecord> certify_family(const CameraModel& family);

/// Certificates of the problems in a file, or in standard input for the name "-": one a line, as
/// parse_general_spec and parse_problem read it; empty lines and lines that begin with # mean
/// nothing. Throws BadInput with the line's number, or if the file cannot be read or has none.
std::vector<ProblemRecord> certify_listed(const std::string& path);

/// Adds `--family NAME` to a command or a group of options.
CLI::Option* add_family_option(CLI::App& app, std::string& family, const std::string& help);

} // namespace plprove
