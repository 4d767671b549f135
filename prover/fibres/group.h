// The monodromy group of the camera solutions of a class: how they are permuted along loops of
// images. Fibres over F_q show permutations in it (proofs/fibres.md).
#pragma once

#include "prover/fibres/class_fibre.h"

#include <string>
#include <vector>

namespace plprove {

struct GroupOptions {
    std::uint64_t seed = 0;
    int fibres = 30; ///< the most that are computed
    /// Called now and then: how many fibres there are, and how many bits the next one takes.
    std::function<void(int, long)> progress = [](int, long) {};
};

/// What fibres show of the group of `degree` solutions.
struct GroupSearch {
    int degree = 0;
    std::vector<std::vector<int>> cycle_types; ///< of one permutation a fibre, ascending
    bool alternating = false; ///< whether a cycle shows that the group contains A_d
    bool even = false;        ///< whether one permutation is even
    bool odd = false;         ///< whether one permutation is odd
    std::string records;      ///< of the fibres that show this

    bool symmetric() const { return alternating && even && odd; }
    /// `S<d>`, `>=A<d>`, or empty, as plcheck will find.
    std::string group() const;
};

/// Whether a prime l has d/2 < l < d - 2, so that a cycle of this length can be looked for.
bool has_cycle_length(int degree);

/// Computes fibres until the group is known, or there are as many as the options say.
GroupSearch find_group(std::size_t number, int degree, const GroupOptions& options);

} // namespace plprove
