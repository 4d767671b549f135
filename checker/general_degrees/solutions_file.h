// Files of solutions (FORMAT.md, section 14): cameras that explain the images of a problem in
// general, with proof.
#pragma once

#include "checker/effort/execution.h"
#include "checker/fibres/frobenius.h"
#include "checker/file/reader.h"
#include "checker/problem/problem.h"

namespace checker {
/// What a record proves: the problem is minimal, and has at least this number of camera solutions.
struct SolutionCount {
    std::string notation{};
    Problem problem{};
    std::size_t solutions = 0;
    /// Of permutations of the solutions, by this and other fibres of the problem
    /// (proofs/fibres.md).
    std::vector<CycleType> cycle_types{};
};

/// What a file of solutions proves.
struct SolutionsFile {
    std::vector<SolutionCount> counts{};
    Refusals refusals{};
};

/// Replays a file after its first line. Throws Malformed.
SolutionsFile replay_solutions(Reader& reader, const Execution& execution);
} // namespace checker
