// Mutators of problem files (certs/FORMAT.md, section 7).
#pragma once

#include "tests/mutation/mutants.h"

namespace mutation {

std::span<const Mutator> problem_mutators();

} // namespace mutation
