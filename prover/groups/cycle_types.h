// What cycles of permutations show of a group of solutions (proofs/fibres.md, Theorem 2).
#pragma once

#include <string>
#include <vector>

namespace plprove {

/// The lengths of the cycles of a permutation, ascending; those of length 1, too.
using CycleType = std::vector<int>;

/// What plcheck finds of the group of `degree` solutions if fibres show permutations with these
/// cycles: `S<d>`, `>=A<d>`, or nothing. `transitive`: the group is known to be.
std::string group_shown_by(const std::vector<CycleType>& cycle_types, int degree, bool transitive);

/// The places of as few cycle types as possible, at most `most`, that show this group; empty if
/// none do. Of those the ones that come first.
std::vector<std::size_t> fewest_that_show(const std::string& group,
                                          const std::vector<CycleType>& cycle_types, int degree,
                                          std::size_t most, bool transitive);

} // namespace plprove
