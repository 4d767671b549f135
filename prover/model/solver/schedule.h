// Straight-line programs in the order in which they run, and the places of their values.
#pragma once

#include "prover/model/solver/derivatives.h"
#include "prover/model/solver/tracking/tracked_program.h"

namespace plprove::model {

/// A program without its plain arrays.
struct Schedule {
    int places = 0;
    std::vector<TrackedConstant> constants;
    std::vector<TrackedDatum> data;
    std::vector<TrackedOperation> operations;
    int operations_at_rest = 0;
    std::vector<TrackedCopy> copies;
    int copies_at_rest = 0;
    std::vector<int> zeros;
};

/// What computes the matrix of TrackedProgram. Values are computed shortly before they are needed,
/// and their places used again: few places fit into a processor's cache.
Schedule scheduled(const Expressions& nodes, const std::vector<DerivedEquation>& equations);

} // namespace plprove::model
