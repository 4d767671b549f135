// The records of a file of problems (FORMAT.md, section 13): each decides whether one problem is
// minimal.
#pragma once

#include "checker/general/jacobian.h"
#include "checker/general/notation.h"
#include "checker/general/part.h"

#include <variant>

namespace checker::general {
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

struct Record {
    std::size_t line = 0;
    Written problem{};
    std::variant<MinorClaim, UnbalancedClaim, CollinearClaim, PartClaim> claim{};

    bool minimal() const { return std::holds_alternative<MinorClaim>(claim); }
};

/// Takes a record. Throws Malformed.
Record read_record(Reader& reader);

/// Throws Refused unless the record proves what it claims.
void check_record(const Record& record);
} // namespace checker::general
