#include "prover/many_views/loop_group.h"

#include "prover/many_views/scene_loops.h"

namespace plprove::many_views {

std::optional<LoopGroup> group_of_loops(const Problem& problem, int degree, std::uint64_t seed,
                                        int threads, const LoopProgress& progress) {
    constexpr std::uint64_t seeds = 4; // one an attempt
    return group_by_loops(progress, [&](std::uint64_t attempt) {
        return SolutionLoops(scene_monodromy(SceneLoops(problem, seeds * seed + attempt, threads)),
                             degree, near_in_general);
    });
}

} // namespace plprove::many_views
