// The command line before and after CLI11 has read it: problems may begin with a dash, and what is
// wrong comes with advice.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace plprove {

/// The words of the command line.
std::vector<std::string> words_of(int argc, char** argv);

/// The same words last first, as CLI11 wants them, and so that it takes none for an option that is
/// none. A problem that begins with `-/` becomes the value of the option before it, or follows all
/// others, behind `--`. The filter after --classes or --also may begin with dashes, too.
std::vector<std::string> for_cli11(const CLI::App& program, std::vector<std::string> words);

/// What was wrong with these words, by the error that CLI11 raised, and what to write instead.
std::string usage_advice(const CLI::App& program, const std::vector<std::string>& words,
                         const CLI::ParseError& error);

/// The most solutions that an option can ask for.
constexpr int largest_target = 1'000'000;

/// Adds `--seed` to a command.
void add_seed(CLI::App& command, std::uint64_t& seed);

} // namespace plprove
