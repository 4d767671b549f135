#include "prover/model/solver/solution_count.h"

#include "prover/model/solver/start.h"

#include <algorithm>

namespace plprove::model {

namespace {

/// How many values of what counts the solutions of a node have.
int values_at(const Program& program, const DataMonodromy& monodromy, int node) {
    SolutionSet<Numbers> seen(near_at_starts, Nearness::of_coordinates);
    for (const Numbers& solution : monodromy.solutions(node).points()) {
        const auto values = counted_values(program, monodromy.loops().data(node), solution);
        if (values && !seen.find(*values)) seen.add(*values);
    }
    return seen.size();
}

} // namespace

MonodromyCount count_solutions(const Program& program, const CountSettings& settings) {
    const TrackedEquations equations(program);
    StartSettings start{settings.seed, settings.threads, 0, settings.found};
    start.most_solutions = settings.most_solutions;
    StartSearch search(program, equations, std::move(start));
    search.run();
    const DataMonodromy& monodromy = search.monodromy();
    const int first = monodromy.solutions(0).size(), second = monodromy.solutions(1).size();
    const MatchedGraph& graph = monodromy.graph();
    return {std::max(values_at(program, monodromy, 0), values_at(program, monodromy, 1)),
            graph.complete_edges(first, second), graph.edges(), monodromy.lost(),
            monodromy.loops().paths()};
}

} // namespace plprove::model
