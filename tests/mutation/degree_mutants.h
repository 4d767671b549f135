// Mutators of degree files and files of upper bounds (certs/FORMAT.md, sections 9 and 10).
#pragma once

#include "tests/mutation/mutants.h"

namespace mutation {

std::span<const Mutator> degree_mutators();

} // namespace mutation
