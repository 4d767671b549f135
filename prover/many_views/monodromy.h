// The solutions of a problem with complete visibility, by monodromy. Where no theorem says how many
// there are, it is evidence, no proof, that monodromy finds no more.
#pragma once

#include "prover/many_views/system.h"
#include "prover/monodromy/count.h"

#include <cstdint>
#include <functional>

namespace plprove::many_views {

/// What monodromy found between two sets of random images.
struct MonodromyResult : MonodromyCount {
    Images<Complex> images;      ///< of the first end
    System system;               ///< that these solve
    std::vector<Point> points{}; ///< the solutions of the first end
};

struct MonodromySettings {
    int edges = 5;
    /// Where few solutions are known: a loop may well leave each of two where it is.
    int edges_of_few = 16;
    int threads = 1;
    int most_solutions = 1'000'000; ///< stops when more are known at the first end
    std::function<void(int known, int edges)> report = {};
};

/// Assumes that the problem is minimal and that all views see everything. The same result for the
/// same seed, whatever the number of threads.
MonodromyResult run_monodromy(const Problem& problem, std::uint64_t seed,
                              const MonodromySettings& settings);

} // namespace plprove::many_views
