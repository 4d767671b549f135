#include "prover/many_views/loop_group.h"

#include "prover/many_views/scene_loops.h"

namespace plprove::many_views {

std::optional<LoopGroup> group_of_loops(const Problem& problem, int degree, std::uint64_t seed,
                                        int threads, const LoopProgress& progress) {
    return group_by_loops(seed, progress, [&](std::uint64_t own_seed) {
        return SolutionLoops(scene_monodromy(SceneLoops(problem, own_seed, threads)), degree,
                             near_in_general);
    });
}

} // namespace plprove::many_views
