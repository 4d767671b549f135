// What the subcommands `problem`, `certify` and `list` do with problems in general.
#pragma once

#include "prover/cli/command.h"
#include "prover/minimal/problem_record.h"

namespace plprove {

/// Certificates of all problems of the family; shows progress on a terminal.
std::vector<ProblemRecord> certify_family(const CameraModel& family);

/// The problems of a list: certificates, and what is said of those that have none.
struct CertifiedList {
    std::vector<ProblemRecord> certificates;
    std::vector<std::string> open; ///< each with the name of the list and the line
};

/// The problems in a file, or in standard input for the name "-": one a line, as parse_general_spec
/// and parse_problem read it; empty lines and lines that begin with # mean nothing. Throws BadInput
/// with the line's number, or if the file cannot be read or has none.
CertifiedList certify_listed(const std::string& path);

/// Adds `--family NAME` to a command or a group of options.
CLI::Option* add_family_option(CLI::App& app, std::string& family, const std::string& help);

} // namespace plprove
