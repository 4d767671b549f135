// The filters of the catalogue as options of a command, and as words in one text.
#pragma once

#include "prover/catalogue/filter.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace plprove {

/// Adds an option for each condition of `filter`, which must outlive the command's parsing.
void add_filters(CLI::App& command, Filter& filter);

/// Adds an option that takes `N`, `N..M`, `N..` or `..M`. `range` must outlive the parsing.
CLI::Option* add_range_option(CLI::App& command, const char* name, std::optional<Range>& range,
                              const char* help);

/// Reads `pl0p`, `one-pin points ..4`, `2394`, `2394,6723 100..200`: the options of add_filters,
/// whose dashes may be left out, and numbers of classes. Throws std::invalid_argument that says
/// what is wrong.
ClassFilter parse_class_filter(const std::string& text);

} // namespace plprove
