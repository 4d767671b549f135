// The path tracker for models, with the lanes of the instruction set that the including file is
// compiled for.
//
// No function of the standard library is used here: see prover/tracking/lanes.h.
#pragma once

#include "prover/model/solver/tracking/evaluation.h"
#include "prover/model/solver/tracking/sparse_elimination.h"
#include "prover/tracking/tracker.h"

namespace plprove::model::PLC_LANES {

namespace {

/// The equations of a model on a way of the data, as a Tracker wants them. Points are in a
/// workspace, as their sizes are known only now.
class EquationsOnWay {
public:
    EquationsOnWay(const TrackedProgram& program, const TrackedCurve* curves, LaneNumber* workspace)
        : program_(program), curves_(curves), next_(reinterpret_cast<Number*>(workspace)),
          places_(take(program.places)), correction_(take(program.unknowns)),
          step_speed_(take(program.unknowns)), inverse_(take(program.unknowns)) {
        set_constants(program, places_);
    }

    struct History {
        explicit History(EquationsOnWay& system) {
            for (int m = 0; m < 3; ++m) {
                point[m] = system.take(system.unknowns());
                speed[m] = system.take(system.unknowns());
            }
        }
        Number *point[3], *speed[3];
    };
    /// The same memory for each step: the point is where the program has its unknowns.
    struct Step {
        explicit Step(EquationsOnWay& system) : point(system.places_), speed(system.step_speed_) {}
        Number *point, *speed;
    };

    int unknowns() const { return program_.unknowns; }

    template <bool Moving>
    Real correct(Real time, Step& step) {
        const int n = program_.unknowns;
        evaluate<Moving>(program_, curves_, time, places_);
        SparseElimination elimination(program_, rows(), inverse_);
        elimination.eliminate();
        elimination.substitute(n, correction_);
        if constexpr (Moving) elimination.substitute(n + 1, step_speed_);
        Real change = Real::of(0), norm = Real::of(1);
        for (int k = 0; k < n; ++k) {
            change = change + square(correction_[k]);
            norm = norm + square(step.point[k]);
            step.point[k] = step.point[k] + correction_[k];
        }
        return change / norm;
    }

private:
    Number* take(int count) {
        Number* part = next_;
        next_ += count;
        return part;
    }

    Rows rows() const {
        return {places_ + program_.unknowns, program_.unknowns, program_.columns()};
    }

    const TrackedProgram& program_;
    const TrackedCurve* curves_;
    Number* next_; // of the workspace
    Number *places_, *correction_, *step_speed_, *inverse_;
};

} // namespace

TrackCost track(const TrackedProgram& program, const TrackedCurve* curves,
                const TrackSettings& settings, std::size_t count, const double* starts,
                double* ends, TrackOutcome* outcomes, LaneNumber* workspace) {
    EquationsOnWay equations(program, curves, workspace);
    return Tracker<EquationsOnWay>(equations, settings, count, starts, ends, outcomes).run();
}

} // namespace plprove::model::PLC_LANES
