// Mutants of files of problems in general. What the checker then claims of a problem has to agree
// with the rank that FLINT computes of its images.
#pragma once

#include "checker/problem/classes.h"

/// 0 if every record of the archives is accepted and no mutant that is accepted claims what is not
/// so.
int try_problems_in_general(const checker::Classification& all, std::size_t mutants,
                            std::uint64_t seed);
