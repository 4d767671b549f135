// The monodromy group of a problem with complete visibility by loops of images: evidence.
#pragma once

#include "prover/monodromy/loop_group.h"
#include "prover/problem/problem.h"

namespace plprove::many_views {

/// Permutations of the `degree` solutions of the problem, each of which is found once. Nothing
/// where too many paths are lost, or there are not as many.
std::optional<LoopGroup> group_of_loops(const Problem& problem, int degree, std::uint64_t seed,
                                        int threads, const LoopProgress& progress = {});

} // namespace plprove::many_views
