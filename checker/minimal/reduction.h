// The rules that reduce a problem, and what is left when none applies (FORMAT.md, section 7).
#pragma once

#include "checker/minimal/obstruction.h"
#include "checker/problem/notation.h"

namespace checker {
/// Takes the `reduce` lines, and returns the features after the last step. Throws Malformed, or
/// Refused if a line is no step.
Features reduce(Reader& reader, Features list, unsigned views);

/// A problem that is reduced and lifted.
struct Lifted {
    Features features{}; // in the order of section 7
    unsigned weight = 0;
    bool large_star = false; // whether it has a point with 8 pins or more
    Signature signature{};   // of the other features
};

/// Lifts a problem. Throws Refused if a rule still applies. (By Theorems 3 and 5 of the paper and
/// proofs/problems.md, features to which no rule applies are, lifted, the 27, and points with 8
/// pins or more that all views see with all pins; in two views, points that both views see.)
Lifted lift(const Features& list, unsigned views);
} // namespace checker
