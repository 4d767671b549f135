// The families of problems (FORMAT.md, section 13): which problems they have, and their numbers.
#pragma once

#include "checker/family/by_problem.h"

#include <string_view>
#include <variant>

namespace checker {
/// Problems, each but once.
using Problems = ByProblem<std::monostate>;

/// All problems of a family, `plmp` or `projective`.
Problems family(std::string_view name);
} // namespace checker
