// The engine of sweeps over the problems of a family: monodromy, which finds solutions and knows
// of no theorem how many there are.
#pragma once

#include "prover/degree_sweep/subject.h"
#include "prover/three_views/degree.h"

namespace plprove {

/// Finds the solutions of a problem for several sets of random images, until two agree on their
/// number, and writes the record that `plprove degree` writes for one of the seeds 1 to 3 (and so
/// on, for other seeds of the sweep). `complete` is evidence that there are no more. The same run
/// for the same problem and options on any machine.
DegreeRun compute_family_degree(const SweepItem& item, const DegreeOptions& options);

} // namespace plprove
