// Gauss' elimination of a matrix whose coefficients are mostly 0, in a fixed order.
//
// No function of the standard library is used here: see prover/tracking/lanes.h.
#pragma once

#include "prover/model/solver/tracking/tracked_program.h"
#include "prover/tracking/elimination.h"

namespace plprove::model::PLC_LANES {

using namespace plprove::PLC_LANES;

namespace {

/// The matrix of a program: a row is an equation, its columns are the unknowns, then right sides.
class SparseElimination {
public:
    SparseElimination(const TrackedProgram& program, const Rows& matrix, Number* inverse)
        : program_(program), a_(matrix), inverse_(inverse) {}

    void eliminate() {
        for (int s = 0; s < program_.unknowns; ++s) {
            const EliminationStep& step = program_.step[s];
            const int* const rows = program_.index + step.rows;
            const int count = step.columns - step.rows, column = step.column;
            Number* const pivots = a_[rows[0]];
            choose_pivot(
                0, count, [&](int i) { return a_[rows[i]][column]; },
                [&](int i, Mask here) {
                    exchange(pivots[column], a_[rows[i]][column], here);
                    for_others(step, [&](int c) { exchange(pivots[c], a_[rows[i]][c], here); });
                });
            inverse_[s] = inverse_of(pivots[column]);
            for (int i = 1; i < count; ++i) {
                Number* const row = a_[rows[i]];
                const Number factor = row[column] * inverse_[s];
                for_others(step, [&](int c) { row[c] = subtract(row[c], factor, pivots[c]); });
            }
        }
    }

    /// Where the sum of the unknowns times their columns, and of column `right`, is 0.
    void substitute(int right, Number* out) const {
        for (int s = program_.unknowns - 1; s >= 0; --s) {
            const EliminationStep& step = program_.step[s];
            const Number* const row = a_[program_.index[step.rows]];
            Number sum = negative(row[right]);
            for (int k = step.columns; k < step.end; ++k) {
                const int c = program_.index[k];
                sum = subtract(sum, row[c], out[c]);
            }
            out[step.column] = sum * inverse_[s];
        }
    }

private:
    /// The columns that a step changes beside its own.
    template <class Change>
    void for_others(const EliminationStep& step, const Change& change) const {
        for (int k = step.columns; k < step.end; ++k)
            change(program_.index[k]);
        for (int c = program_.unknowns; c < a_.columns; ++c)
            change(c);
    }

    const TrackedProgram& program_;
    Rows a_;
    Number* inverse_;
};

} // namespace

} // namespace plprove::model::PLC_LANES
