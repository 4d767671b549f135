// The monodromy group of the camera solutions of a class, or of a problem in general: how they are
// permuted along loops of images. Fibres over F_q show permutations in it (proofs/fibres.md).
#pragma once

#include "prover/groups/cycle_types.h"
#include "prover/problem/problem.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace plprove {

struct GroupOptions {
    std::uint64_t seed = 0;
    int fibres = 30; ///< the most that are computed
    /// Called now and then: how many fibres there are, and how many bits the next one takes.
    std::function<void(int, long)> progress = [](int, long) {};
};

/// What fibres show of the group of `degree` solutions.
struct GroupSearch {
    int degree = 0;
    std::vector<CycleType> cycle_types; ///< of one permutation a fibre
    std::string group;   ///< `S<d>`, `>=A<d>`, one with blocks, or empty, as plcheck will find
    std::string records; ///< of as few fibres as show this; of the first one if none do
};

/// A fibre, as the search for a group needs it.
struct FibreRecord {
    CycleType cycle_type; ///< of the permutation that it shows
    CycleType matrices;   ///< ... of essential matrices that solutions share; empty if they do not
    std::string record;   ///< without the first line of the file
};

/// The fibre of a seed; nothing where a step fails. Tells how many bits its solutions have.
using FindFibre =
    std::function<std::optional<FibreRecord>(std::uint64_t seed, const std::function<void(long)>&)>;

/// Computes fibres until the group is known, there are as many as the options say, or too many
/// steps have failed. One solution needs one fibre only.
GroupSearch search_group(int degree, const GroupOptions& options, const FindFibre& find_fibre);

/// Of a label class.
GroupSearch find_group(std::size_t number, int degree, const GroupOptions& options);

/// Of a minimal problem whose views see everything, with cameras that have their coordinates once.
GroupSearch find_group(const Problem& problem, int degree, const GroupOptions& options);

} // namespace plprove
