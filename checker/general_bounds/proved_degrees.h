// Upper bounds of problems that pages of proofs/ treat one by one.
#pragma once

#include "checker/problem/problem.h"

#include <string_view>

namespace checker {
/// So many solutions for its cameras a minimal problem has at most, by this theorem.
struct ProvedDegree {
    std::size_t at_most = 0;
    std::string_view theorem{};
};

/// The bound of the problem's row in the theorems' tables, whatever the names of its points and
/// lines; none if it has no row.
std::optional<ProvedDegree> proved_degree(const Problem& problem);
} // namespace checker
