// Files of upper bounds (FORMAT.md, section 15): problems for projective cameras have at most so
// many solutions.
#pragma once

#include "checker/effort/execution.h"
#include "checker/file/reader.h"
#include "checker/problem/problem.h"

namespace checker {
/// What a record proves: if the problem is minimal, it has at most this number of camera solutions.
struct SolutionBound {
    std::string notation{};
    Problem problem{};
    std::size_t at_most = 0;
};

/// What a file of upper bounds proves.
struct AtMostFile {
    std::vector<SolutionBound> bounds{};
    Refusals refusals{};
};

/// Replays a file after its first line. Throws Malformed.
AtMostFile replay_at_most(Reader& reader, const Execution& execution);
} // namespace checker
