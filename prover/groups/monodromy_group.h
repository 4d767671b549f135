// What a permutation group says about a problem whose solutions it permutes: into which steps the
// problem decomposes, and how many solutions the hardest of them has.
#pragma once

#include "prover/groups/permutation.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace plprove {

/// A number, by the exponents of its prime factors.
using Factored = std::map<int, int>;

/// One step: each solution of the steps before has `solutions` ones here.
struct GroupStep {
    int solutions = 0; ///< how many points a block has, of solutions or of finer blocks
    int copies = 1;    ///< how many solutions the steps before have in all
    /// Which permutations of the points of a block there are, by those that keep the block: all,
    /// all even ones, or others.
    enum class Kind : std::uint8_t { symmetric, alternating, other } kind = Kind::other;
    /// Of the group on these points, those permutations that keep each block make a subgroup of
    /// the order solutions!^copies / index.
    Factored index;

    friend bool operator==(const GroupStep&, const GroupStep&) = default;
};

/// A transitive group that some permutations generate. The steps are those of the finest chain of
/// blocks, the coarsest blocks first: one step if the group is primitive.
struct MonodromyGroup {
    std::vector<GroupStep> steps;

    int degree() const;
    bool is_symmetric() const;
    /// `S312`, `A64`; of several steps, the first one last: `S8 wr S2 wr S10`; with `<` before a
    /// proper subgroup.
    std::string name() const;
    /// As a product: `312!`, `8!^20*2!^10*10!/2`.
    std::string order() const;
    /// The Galois width: the largest number of solutions of an equation that has to be solved. At
    /// most this where a step is of another kind than all or all even permutations.
    int width() const;

    friend bool operator==(const MonodromyGroup&, const MonodromyGroup&) = default;
};

/// Assumes that the group is transitive.
MonodromyGroup monodromy_group(const std::vector<Permutation>& generators);

/// Whether the group that the permutations generate is transitive, and has a cycle by which it
/// contains all even permutations (jordan.h). If it contains these, that is overlooked once in
/// 10,000 times; always for degrees below 8.
bool shows_alternating(const std::vector<Permutation>& generators);

/// Maps of one set to another, each along an edge: the permutations of the first set that go along
/// the first edge and back along each other one.
std::vector<Permutation> loops_of_edges(const std::vector<Permutation>& bijections);

/// The group of the loops of these edges: S_d, if it is so whichever edge is left out. Then no edge
/// that was followed wrongly makes it so alone. Nothing if it is not, or for fewer than four edges.
std::optional<MonodromyGroup> symmetric_group_of_edges(const std::vector<Permutation>& bijections);

} // namespace plprove
