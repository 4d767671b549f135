// Whether the degrees on file obey the laws, where a mistake may be, and which degrees a law
// guards.
#pragma once

#include "tests/laws/equations.h"

#include <iosfwd>

namespace laws {

/// What the laws say about a table of degrees.
struct Verdict {
    bool hold = true;
    std::vector<std::string> report;   ///< lines
    std::vector<std::size_t> suspects; ///< numbers of classes in which a mistake may be, if not
};

/// Checks the relations, the ranks and the Hodge index, and names suspects where one fails.
Verdict check(const DegreeForm& form);

/// For each class whether a law guards it: whether the relations or the ranks fail with any other
/// degree of this class, all others unchanged. Assumes that all laws hold.
std::vector<bool> guarded_classes(const DegreeForm& form);

/// Copies degrees.csv with the word `guarded` at the end of the source in just those lines of
/// evidence whose class a law guards.
void mark_guarded(std::istream& file, std::ostream& out, const DegreeForm& form,
                  const std::vector<bool>& guarded);

} // namespace laws
