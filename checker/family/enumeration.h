// Which problems a family has (FORMAT.md, section 13). proofs/families.md, section 6, proves that
// none is missing.
#pragma once

#include "checker/family/by_problem.h"
#include "checker/family/family.h"

#include <variant>

namespace checker {
/// Problems, each but once.
using Problems = ByProblem<std::monostate>;

Problems problems_of(const Family& family);
} // namespace checker
