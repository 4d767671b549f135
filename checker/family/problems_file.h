// Files of problems (FORMAT.md, section 13): single problems, or all of a family.
#pragma once

#include "checker/effort/execution.h"
#include "checker/file/reader.h"
#include "checker/problem/problem.h"

namespace checker {
/// What a record proves.
struct ProblemVerdict {
    std::string notation{};
    Problem problem{};
    bool minimal = false;
};

/// What a file of problems proves.
struct ProblemsFile {
    std::string family{};    // empty if the file claims none
    std::size_t missing = 0; // problems of the family that have no record that holds
    std::vector<ProblemVerdict> verdicts{};
    Refusals refusals{};
};

/// Replays a file after its first line. Throws Malformed.
ProblemsFile replay_problems(Reader& reader, const Execution& execution);
} // namespace checker
