// What a program takes, as a text for other programs: manual pages and shell completion are made
// from it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace plprove {

/// One line a fact, its words separated by tabs:
///
///     program   NAME     SUMMARY
///     command   NAME     SUMMARY      what follows, to the next command, belongs to this one
///     operand   NAMES    VALUE        DESCRIPTION
///     option    NAMES    VALUE        DESCRIPTION
///     text      LINE                  a line below the options in the help, once for each line
///
/// NAMES are separated by commas. VALUE is as in the help (`N or N..M`, `{a,b}=a REQUIRED`), and
/// empty for a flag. A SUMMARY and a DESCRIPTION fill one line each.
std::string describe(const CLI::App& program);

} // namespace plprove
