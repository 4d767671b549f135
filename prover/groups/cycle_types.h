// What cycles of permutations show of a group of solutions (proofs/fibres.md, Theorem 2).
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace plprove {

/// The lengths of the cycles of a permutation, ascending; those of length 1, too.
using CycleType = std::vector<int>;

/// What plcheck finds of the group of `degree` solutions if fibres show permutations with these
/// cycles: `S<d>`, `>=A<d>`, or nothing. `transitive`: the group is known to be.
std::string group_shown_by(const std::vector<CycleType>& cycle_types, int degree, bool transitive);

/// A permutation of solutions, some of which share essential matrices, and of these.
struct SharedCycles {
    CycleType solutions, matrices;
};

/// What plcheck finds of the group of `degree` solutions if fibres show these permutations, and a
/// theorem says that there are so few matrices: `S2 wr S136`, `<S8 wr S2 wr S10`, or nothing.
std::string group_with_blocks(const std::vector<SharedCycles>& all, int degree);

/// Whether it may find a group of this name.
bool may_be_shown_with_blocks(const std::string& group);

/// The places of as few of so many permutations as possible, at least two, at most `most`, that
/// show what is wanted, as the function says; the first such ones; empty if there are none.
std::vector<std::size_t>
fewest_that_show(std::size_t count, std::size_t most,
                 const std::function<bool(const std::vector<std::size_t>&)>& shows);

} // namespace plprove
