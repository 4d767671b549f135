// Blocks of a transitive group: sets that every permutation moves as a whole.
#pragma once

#include "prover/groups/permutation.h"

namespace plprove {

/// Sets of equal size. `block_of` says of each point in which set it is; sets are numbered from 0
/// by their first points.
struct BlockSystem {
    std::vector<int> block_of;
    int blocks = 0;

    int block_size() const { return static_cast<int>(block_of.size()) / blocks; }
};

/// Whether the group that the permutations generate moves each point to each.
bool is_transitive(const std::vector<Permutation>& generators);

/// The finest system of a transitive group that has two points in one block (Atkinson, 1975).
BlockSystem blocks_joining(const std::vector<Permutation>& generators, int point, int other);

/// The blocks of least size that have more than one point. A single block if the group is
/// primitive.
BlockSystem least_blocks(const std::vector<Permutation>& generators);

/// How the permutations move the blocks.
std::vector<Permutation> on_blocks(const std::vector<Permutation>& generators,
                                   const BlockSystem& system);

} // namespace plprove
