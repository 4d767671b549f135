// The monodromy group of a class by loops of images: evidence.
#pragma once

#include "prover/monodromy/loop_group.h"

namespace plprove {

/// Permutations of the `degree` solutions of the class, which a theorem counts. Nothing where too
/// many paths are lost.
std::optional<LoopGroup> group_of_loops(std::size_t number, int degree, std::uint64_t seed,
                                        const LoopProgress& progress = {});

} // namespace plprove
