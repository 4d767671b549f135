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
    const auto first = std::ssize(points), second = std::ssize(distinct(monodromy, 1));
    const MatchedGraph& graph = monodromy.graph();
    const SceneLoops& loops = monodromy.loops();
    MonodromyResult result{{static_cast<int>(std::max(first, second)), 0, graph.edges(),
                            monodromy.lost(), loops.paths()},
                           loops.images(0),
                           loops.system(),
                           points};
    for (int edge = 0; edge < graph.edges(); ++edge)
        result.edges += first == second && graph.matched(edge) == first;
    return result;
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
