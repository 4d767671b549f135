// What a sweep has to compute, and in which order.
#pragma once

#include "prover/degree_sweep/folder.h"

#include <vector>

namespace plprove {

struct SweepPlan {
    DegreeOptions options;
    std::vector<std::size_t> numbers; ///< of items that lack a result, in the order of computation
    std::vector<double> costs;        ///< how many solutions each shall have
    unsigned threads = 1;
};

/// How a sweep wants to go about these items: those without a result that fulfils the options, the
/// ones of small degree first, and those of unknown degree last. With `retry`, items go in again
/// whose last run stopped short, or whose record is damaged. Throws BadInput as
/// SweepFolder::require_place() does.
SweepPlan plan_sweep(const SweepFolder& folder, const std::vector<std::size_t>& numbers,
                     const DegreeOptions& options, bool retry);

/// The items that one of several processes computes; the first has the number 0. They are dealt out
/// to and fro by their degrees, largest first, whatever is on file: processes that share a folder
/// need not agree on what they find there.
std::vector<std::size_t> share_of(const SweepSubject& subject, std::vector<std::size_t> numbers,
                                  std::size_t process, std::size_t processes);

} // namespace plprove
