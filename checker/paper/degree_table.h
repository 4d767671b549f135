// Table 2 of the paper: how many terminal problems have a degree, for all degrees below a limit.
#pragma once

#include "checker/paper/claims.h"
#include "checker/paper/numbers.h"

#include <span>

namespace checker::paper {
/// A terminal problem, and what is known of its degree.
struct TerminalProblem {
    std::size_t number = 0; // of its class
    std::string problem{};
    DegreeBounds bounds{};
};

/// A part of Table 2: its claims, and the problems that they are about.
struct PaperTable {
    std::string_view name{};
    std::size_t limit = 0;
    std::size_t claimed_problems = 0; // of all degrees
    std::span<const ClaimedDegrees> claims{};
    std::vector<TerminalProblem> problems{};
};

PaperTable table_2a_of(const KnownDegrees& known);
PaperTable table_2b_of(const KnownDegrees& known);

/// Adds the lines of a table.
void add_table(std::vector<DegreeClaim>& lines, const PaperTable& table);
} // namespace checker::paper
