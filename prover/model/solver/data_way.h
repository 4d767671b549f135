// Following solutions of a model while its data move.
#pragma once

#include "prover/model/solver/numeric_equations.h"
#include "prover/model/solver/tracked_equations.h"
#include "prover/monodromy/path_ends.h"

namespace plprove::model {

/// From some data to others, at t = 0 and 1. In between they are away from the straight way by
/// t (1 - t) times the bend, which has one number for each scalar of data.
struct DataWay {
    const Numbers& from;
    const Numbers& to;
    const Numbers& bend;
};

/// How carefully a path is followed: `careful` takes some five times the steps, and jumps to other
/// paths more rarely.
enum class Care : std::uint8_t { usual, careful };

/// Where the paths of solutions lead, by `threads` threads, side by side; nothing where one gets
/// lost.
PathEnds<Numbers> follow_all(const TrackedEquations& equations, const DataWay& way,
                             const std::vector<Numbers>& starts, Care care, unsigned threads);

} // namespace plprove::model
