// Mutants of degree files and of files of upper bounds. What the checker claims of degrees, the
// degree referee has to find, and it may be no more than the known degree; upper bounds may not be
// less than the number of solutions that degree files show.
#pragma once

#include "checker/problem/classes.h"

/// 0 if every file is accepted and no mutant that is accepted claims what is not so.
int try_degree_files(const checker::Classification& all, std::size_t mutants, std::uint64_t seed);
int try_bounds(const checker::Classification& all, std::size_t mutants, std::uint64_t seed);
