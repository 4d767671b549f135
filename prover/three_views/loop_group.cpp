#include "prover/three_views/loop_group.h"

#include "prover/three_views/camera_loops.h"

namespace plprove {

std::optional<LoopGroup> group_of_loops(std::size_t number, int degree, std::uint64_t seed,
                                        const LoopProgress& progress) {
    const CameraSystem system = camera_system(label_classes()[number]);
    return group_by_loops(seed, progress, [&](std::uint64_t own_seed) {
        return SolutionLoops(camera_monodromy(CameraLoops(system, own_seed, number)), degree,
                             near_at_path_ends);
    });
}

} // namespace plprove
