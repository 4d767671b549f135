// The families of problems (FORMAT.md, section 13): which problems they have, and their numbers.
#pragma once

#include "checker/problem/isomorphism.h"

#include <map>
#include <string_view>

namespace checker {
/// Problems that are pairwise not isomorphic, by their invariants.
using IsomorphismClasses = std::map<Invariant, std::vector<Problem>>;

/// The problem of a class that is isomorphic to this one; null if there is none.
const Problem* find(const IsomorphismClasses& classes, const Problem& problem);

/// One problem of each class of a family, `plmp` or `projective`.
IsomorphismClasses family(std::string_view name);
} // namespace checker
