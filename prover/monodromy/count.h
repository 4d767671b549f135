// What monodromy says of a number of solutions.
#pragma once

#include <cstdint>

namespace plprove {

/// Two sets of random data are joined by several ways; the solutions of one end go to those of the
/// other along each.
struct MonodromyCount {
    int solutions = 0; ///< known at the end where more are
    int edges = 0;     ///< ways along which all of both ends are matched one to one
    int ways = 0;      ///< all of them
    int lost = 0;      ///< paths that got lost, or jumped
    std::int64_t paths = 0;

    /// Whether all ways agree: evidence that no solution is missing.
    bool complete() const { return edges == ways; }
};

} // namespace plprove
