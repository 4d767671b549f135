// Computes the degrees of many classes, several at a time, and keeps each result as soon as it is
// there. Which thread computes which class, and when, has no part in any result.
#pragma once

#include "prover/degree_sweep/folder.h"

#include <functional>

namespace plprove {

/// compute_degree, or another engine in its place. Called by several threads at a time.
using ComputeDegree = std::function<DegreeRun(std::size_t, const DegreeOptions&)>;

struct SweepPlan {
    DegreeOptions options;
    std::vector<std::size_t> classes; ///< that lack a result, in the order of computation
    std::vector<double> costs;        ///< what each is expected to cost, in any unit
    std::size_t on_file = 0;          ///< how many more have one
    unsigned threads = 1;
};

/// How a sweep wants to go about these classes: those without a result that fulfils the options go
/// first that are expected to have the fewest solutions, by what is known of their degrees in the
/// folder or in certs/degrees.csv. With `retry`, classes go in again whose last run stopped short.
SweepPlan plan_sweep(const SweepFolder& folder, const std::vector<std::size_t>& classes,
                     const DegreeOptions& options, bool retry);

struct SweepProgress {
    std::size_t done = 0, total = 0; ///< classes that lacked a result
    double seconds = 0;              ///< since the sweep began
    double share = 0;                ///< of the cost expected
};

/// Called a few times a second by the thread that called sweep().
struct SweepWatch {
    std::function<void(const SweepProgress&)> progress;
    /// While no file is being written: may end the process.
    std::function<void()> pause;
};

/// Computes the classes of the plan. A class whose computation throws is put on file as one of
/// which nothing is known, with the reason as a note. Throws what writing a file throws, or
/// std::bad_alloc, once the classes that were being computed are done with.
void sweep(const SweepFolder& folder, const SweepPlan& plan, const ComputeDegree& compute,
           const SweepWatch& watch);

} // namespace plprove
