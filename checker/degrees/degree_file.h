// Degree files (FORMAT.md, section 9): cameras that explain the images of a class, with proof.
#pragma once

#include "checker/effort/execution.h"
#include "checker/file/reader.h"
#include "checker/problem/classes.h"

#include <optional>

namespace checker {
/// A permutation of solutions, with what a fibre says of it (proofs/fibres.md).
struct FrobeniusElement {
    std::size_t solutions = 0; // that are proved to be permuted; the others are not known
    bool even = false;         // the permutation of these
    std::size_t cycle = 0;     // a prime, the length of a cycle; 0 if none is named
};

/// What a record proves: its class has at least this number of camera solutions.
struct LowerBound {
    std::size_t number = 0; // of the label class
    std::size_t solutions = 0;
    std::optional<FrobeniusElement> frobenius{}; // of a fibre
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
