// Problem files (FORMAT.md, section 7): the certificate of the verdict on any problem in two or
// three views. The checker derives the verdict; the file has to say the same, and to prove it.
#pragma once

#include "checker/minimal/classification_file.h"
#include "checker/problem/canonical.h"

#include <optional>

namespace checker {
/// What a problem file proves.
struct ProblemFile {
    std::string problem{};           // in notation
    Problem meaning{};               // the same problem
    CanonicalProblem canonical{};    // the same problem
    std::string verdict{};           // empty if the file is refused
    std::optional<Verdict> of_class; // on the label class of the lifted problem, if it has one
    Refusals refusals{};
};

/// Replays a file after its first line. Throws Malformed.
ProblemFile replay_problem(Reader& reader, const Classification& classes);
} // namespace checker
