#include "prover/many_views/monodromy.h"

#include "prover/many_views/distinct.h"
#include "prover/many_views/scene_loops.h"

#include <algorithm>

namespace plprove::many_views {

namespace {

std::vector<Point> distinct(const SceneMonodromy& monodromy, int node) {
    const SceneLoops& loops = monodromy.loops();
    return distinct_solutions(loops.system(), loops.images(node),
                              monodromy.solutions(node).points());
}

MonodromyResult result_of(const SceneMonodromy& monodromy) {
    const std::vector<Point> points = distinct(monodromy, 0);
    const int first = static_cast<int>(points.size());
    const int second = static_cast<int>(distinct(monodromy, 1).size());
    const MatchedGraph& graph = monodromy.graph();
    const SceneLoops& loops = monodromy.loops();
    return {{std::max(first, second), graph.complete_edges(first, second), graph.edges(),
             monodromy.lost(), loops.paths()},
            loops.images(0),
            loops.system(),
            points};
}

} // namespace

MonodromyResult run_monodromy(const Problem& problem, std::uint64_t seed,
                              const MonodromySettings& settings) {
    SceneMonodromy::Report report;
    if (settings.report)
        report = [&](const MonodromyProgress& progress) {
            settings.report(progress.solutions, progress.edges);
        };
    SceneMonodromy monodromy =
        scene_monodromy(SceneLoops(problem, seed, settings.threads), std::move(report));
    monodromy.until_agreed({settings.edges, settings.edges_of_few, settings.most_solutions});
    return result_of(monodromy);
}

} // namespace plprove::many_views
