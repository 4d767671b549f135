// What a sweep has to compute, and in which order.
#pragma once

#include "prover/degree_sweep/folder.h"

#include <vector>

namespace plprove {

struct SweepPlan {
    DegreeOptions options;
    std::vector<std::size_t> classes; ///< that lack a result, in the order of computation
    std::vector<double> costs;        ///< what each is expected to cost, in any unit
    std::size_t on_file = 0;          ///< how many more have one
    unsigned threads = 1;
};

/// How a sweep wants to go about these classes: those without a result that fulfils the options go
/// first that are expected to have the fewest solutions, by what is known of their degrees in the
/// folder or in certs/degrees.csv. With `retry`, classes go in again whose last run stopped short,
/// or whose record is damaged. Throws BadInput as SweepFolder::require_place() does.
SweepPlan plan_sweep(const SweepFolder& folder, const std::vector<std::size_t>& classes,
                     const DegreeOptions& options, bool retry);

/// The same plan in the opposite order. Smallest first has results early, and ends with all but one
/// of the workers waiting for the largest class: the more workers, the more that wastes. Largest
/// first, the last classes are small, and all workers end together.
SweepPlan largest_first(SweepPlan plan);

} // namespace plprove
