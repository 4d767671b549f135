// How many solutions a model has for generic data, by monodromy: evidence.
#pragma once

#include "prover/model/program.h"
#include "prover/monodromy/count.h"

#include <functional>

namespace plprove::model {

struct CountSettings {
    std::uint64_t seed = 0;
    unsigned threads = 1;                              ///< the count is the same
    int most_solutions = 20'000;                       ///< stops when more are known
    std::function<void(std::size_t found)> found = {}; ///< told how many are known
};

/// Of solutions with the same value of what counts, one is counted. Assumes as many equations as
/// unknowns. Throws BadInput where not even one solution is found.
MonodromyCount count_solutions(const Program& program, const CountSettings& settings);

} // namespace plprove::model
