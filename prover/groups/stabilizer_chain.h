// The order of a permutation group, by a chain of stabilizers from random elements (Schreier and
// Sims; Leon, 1980).
#pragma once

#include "prover/groups/permutation.h"

namespace plprove {

/// Stabilizers of more and more points, and where each moves the next point.
class StabilizerChain {
public:
    /// Of the group that the permutations generate, at least one. It is right but for bad luck with
    /// random elements, as in one of 100,000 cases.
    explicit StabilizerChain(const std::vector<Permutation>& generators);

    /// The length of the orbit of each base point under the stabilizer of those before. Their
    /// product is the order.
    std::vector<int> orbit_lengths() const;

private:
    struct Level {
        int point = 0;
        std::vector<Permutation> inverses; ///< of permutations that generate the stabilizer
        std::vector<int> orbit;
        std::vector<int> arrived_by; ///< for each point: which of them moved the orbit there, or -1
    };

    /// Multiplies the element by others of the chain until it fixes the points of all levels, one
    /// after the other. Where one level learns from it, the chain grows. Whether it did.
    bool learn(Permutation element);
    /// Whether the element moves the point of the level out of its orbit.
    static bool leaves(const Level& level, const Permutation& element);
    static void add(Level& level, const Permutation& element);

    std::vector<Level> levels_;
};

} // namespace plprove
