// Degree files (FORMAT.md, section 9): cameras that explain the images of a class, with proof.
#pragma once

#include "checker/effort/execution.h"
#include "checker/fibres/frobenius.h"
#include "checker/file/reader.h"
#include "checker/problem/classes.h"

namespace checker {
/// How a permutation of solutions permutes essential matrices of two views that some share.
struct BlockCycles {
    Views views = 0;
    CycleType solutions{}, matrices{};
};

/// What a record proves: its class has at least this number of camera solutions.
struct LowerBound {
    std::size_t number = 0; // of the label class
    std::size_t solutions = 0;
    /// Of permutations of the solutions, by this and other fibres of the class (proofs/fibres.md).
    std::vector<CycleType> cycle_types{};
    std::vector<BlockCycles> block_cycles{}; // of the same permutations
};

/// What a degree file proves.
struct DegreeFile {
    std::vector<LowerBound> bounds{};
    Refusals refusals{};
};

/// Replays a file after its first line. Throws Malformed.
DegreeFile replay_degrees(Reader& reader, const Classification& classes,
                          const Execution& execution);
} // namespace checker
