// The monodromy group of a model by loops of its data: evidence.
#pragma once

#include "prover/model/program.h"
#include "prover/monodromy/loop_group.h"

namespace plprove::model {

/// How many solutions a model has for generic data: zeros that are regular, and values of these
/// that count.
struct ModelSize {
    int solutions = 0, values = 0;
};

/// The group of the values that count.
struct ModelGroup {
    int loops = 0; ///< how many permutations generate it
    /// Of the values that loops lead to one another, the sets of few values first: each for itself.
    /// One, if the group is transitive.
    std::vector<MonodromyGroup> parts;
};

/// By loops of random data. Nothing where too many paths are lost, or there are not as many
/// solutions. Throws BadInput where there are no data that have one.
std::optional<ModelGroup> group_of_loops(const Program& program, const ModelSize& size,
                                         std::uint64_t seed, unsigned threads,
                                         const LoopProgress& progress = {});

} // namespace plprove::model
