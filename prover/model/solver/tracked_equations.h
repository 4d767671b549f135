// The equations of a model, ready for the path tracker.
#pragma once

#include "prover/model/program.h"
#include "prover/model/solver/elimination_order.h"
#include "prover/model/solver/tracking/tracked_program.h"

#include <vector>

namespace plprove::model {

/// A straight-line program for the equations and their derivatives, in the plain arrays of the
/// tracker.
class TrackedEquations {
public:
    /// Assumes as many equations as unknowns.
    explicit TrackedEquations(const Program& program);
    TrackedEquations(const TrackedEquations&) = delete;
    TrackedEquations& operator=(const TrackedEquations&) = delete;

    const TrackedProgram& tracked() const { return program_; }

private:
    TrackedProgram program_;
    // What the plain arrays point to.
    std::vector<TrackedConstant> constants_;
    std::vector<TrackedDatum> data_;
    std::vector<TrackedOperation> operations_;
    std::vector<TrackedCopy> copies_;
    std::vector<int> zeros_;
    EliminationOrder order_;
};

} // namespace plprove::model
