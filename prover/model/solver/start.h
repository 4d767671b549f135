// Where the paths to all data begin: random complex data, with all solutions that are found.
#pragma once

#include "prover/model/solver/data_way.h"

#include <functional>

namespace plprove::model {

struct Start {
    Numbers data;
    std::vector<Numbers> solutions;
};

struct StartSettings {
    std::uint64_t seed = 0;
    unsigned threads = 1;
    /// How many solutions there are, 0 if that is not known: then the search ends when several
    /// loops, and several other solutions, lead to no new ones.
    std::size_t known = 0;
    std::function<void(std::size_t found)> found = {}; ///< told how many are found
};

/// Solutions by monodromy, from random ones. Throws BadInput where not even one is found. The same
/// for the same seed, whatever the number of threads.
Start find_start(const Program& program, const TrackedEquations& equations,
                 const StartSettings& settings);

} // namespace plprove::model
