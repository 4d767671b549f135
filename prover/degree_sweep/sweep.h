// Computes the degrees of many classes or problems by the threads of one process, and keeps each
// result as soon as it is there. Which thread computes which one, and when, has no part in any
// result.
#pragma once

#include "prover/degree_sweep/plan.h"

#include <functional>

namespace plprove {

/// compute_degree, or another engine in its place. Called by several threads at a time.
using ComputeDegree = std::function<DegreeRun(std::size_t, const DegreeOptions&)>;

struct SweepProgress {
    std::size_t done = 0, total = 0; ///< items that lacked a result
    double seconds = 0;              ///< since the sweep began
    double share = 0;                ///< of the cost expected
};

/// Called a few times a second by the thread that called sweep().
struct SweepWatch {
    std::function<void(const SweepProgress&)> progress;
    /// While no file is being written: may end the process.
    std::function<void()> pause;
};

/// Computes the items of the plan. One whose computation throws is put on file as one of which
/// nothing is known, with the reason as a note. Throws what writing a file throws, or
/// std::bad_alloc, once the items that are being computed are done with.
void sweep(const SweepFolder& folder, const SweepPlan& plan, const ComputeDegree& compute,
           const SweepWatch& watch);

} // namespace plprove
