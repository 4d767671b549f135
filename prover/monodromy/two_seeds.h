// When monodromy counts as evidence of a degree: two seeds have to agree.
#pragma once

#include "prover/monodromy/count.h"

#include <map>
#include <optional>

namespace plprove {

/// A number of solutions that runs of monodromy found.
struct CountedTwice {
    int solutions = 0;
    bool exact = false;              ///< two seeds gave it, and most ways agree for both
    int agreeing_ways = 0, ways = 0; ///< of all seeds that gave it
};

/// Asks `count` for the number by seeds from 1 on, until two of a few agree; else it is the
/// smallest, as a run may count a solution twice. Nothing if one finds more than `most`.
template <class Count>
std::optional<CountedTwice> counted_twice(int most, std::uint64_t most_seeds, const Count& count) {
    struct Finding {
        int seeds = 0; // for which most ways agree
        int agreeing_ways = 0, ways = 0;
    };
    std::map<int, Finding> findings; // by the number of solutions
    for (std::uint64_t seed = 1; seed <= most_seeds; ++seed) {
        const MonodromyCount found = count(seed);
        if (found.solutions > most) return std::nullopt;
        Finding& finding = findings[found.solutions];
        finding.agreeing_ways += found.edges;
        finding.ways += found.ways;
        if (2 * found.edges >= found.ways) ++finding.seeds;
        if (finding.seeds == 2)
            return CountedTwice{found.solutions, true, finding.agreeing_ways, finding.ways};
    }
    const auto& [solutions, finding] = *findings.begin();
    return CountedTwice{solutions, false, finding.agreeing_ways, finding.ways};
}

} // namespace plprove
