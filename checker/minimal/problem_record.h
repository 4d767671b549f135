// The records of a file of problems (FORMAT.md, section 13): each decides whether one problem is
// minimal.
#pragma once

#include "checker/minimal/block.h"
#include "checker/minimal/part.h"
#include "checker/problem/notation.h"

#include <variant>

namespace checker {
/// Minimal: det J at these cameras and this scene is not 0.
struct MinorClaim {
    Residue minor{};
    Placement placement{};
};

/// Not minimal: the problem is not balanced.
struct UnbalancedClaim {};

/// Not minimal: two views see four points of a line.
struct CollinearClaim {
    Indices points{};
    Views views = 0;
};

struct ProblemRecord {
    std::size_t line = 0;
    Written problem{};
    std::variant<MinorClaim, UnbalancedClaim, CollinearClaim, PartClaim> claim{};

    bool minimal() const { return std::holds_alternative<MinorClaim>(claim); }
};

/// Takes a record. Throws Malformed.
ProblemRecord read_problem_record(Reader& reader);

/// Throws Refused unless the record proves what it claims.
void check_record(const ProblemRecord& record);
} // namespace checker
