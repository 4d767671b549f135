// The monodromy group by the permutations that loops of images make: evidence.
#pragma once

#include "prover/groups/blocks.h"
#include "prover/groups/monodromy_group.h"
#include "prover/monodromy/solution_loops.h"

namespace plprove {

struct LoopGroup {
    MonodromyGroup group; ///< that the permutations generate
    int loops = 0;        ///< how many permutations these are
};

/// Is told how many loops there are.
using LoopProgress = std::function<void(int)>;

/// More and more permutations of one set of solutions. Solutions is SolutionLoops, or has the same
/// functions.
template <class Solutions>
class LoopPermutations {
public:
    LoopPermutations(Solutions solutions, const LoopProgress& progress)
        : solutions_(std::move(solutions)), progress_(progress) {}

    /// Adds so many. Whether these are there.
    bool add(int more, bool both_ways) {
        constexpr int too_many = 20;
        int lost = 0;
        while (more > 0) {
            auto next = both_ways ? solutions_.next_both_ways() : solutions_.next();
            if (!next && ++lost == too_many) return false;
            if (!next) continue;
            permutations_.push_back(std::move(*next));
            --more;
            if (progress_) progress_(count());
        }
        return true;
    }

    int count() const { return static_cast<int>(permutations_.size()); }
    const std::vector<Permutation>& permutations() const { return permutations_; }

private:
    Solutions solutions_;
    const LoopProgress& progress_;
    std::vector<Permutation> permutations_;
};

/// The group by as few edges as will do, if it is S_d. Some more edges are tried for the sake of
/// the sign: it takes two of either.
template <class Solutions>
std::optional<LoopGroup> symmetric_group_of(Solutions& solutions, const LoopProgress& progress) {
    constexpr int fewest = 4;
    constexpr int most = 7;
    for (int edges = fewest; edges <= most; ++edges) {
        solutions.add_bijections(edges);
        const std::vector<Permutation>& known = solutions.bijections();
        if (std::ssize(known) < edges || !shows_alternating(loops_of_edges(known))) return {};
        if (progress) progress(edges - 1);
        if (auto group = symmetric_group_of_edges(known)) return LoopGroup{*group, edges - 1};
    }
    return {};
}

/// Follows loops until ten more of these make the group no larger, or until they make it S_d.
/// Nothing where too many paths are lost, or the group is not transitive.
template <class Solutions>
std::optional<LoopGroup> group_of(LoopPermutations<Solutions>& loops) {
    // A jump may make a group larger, not smaller. So what is soon found to be S_d is followed both
    // ways; and a group that seems to be smaller, by more loops.
    constexpr int few = 3;
    constexpr int enough = 10;
    constexpr int most = 100;
    std::optional<MonodromyGroup> group;
    while (loops.count() < most) {
        const bool at_first = loops.count() < 2 * few;
        if (!loops.add(at_first ? few : enough, at_first)) return std::nullopt;
        if (!is_transitive(loops.permutations())) continue;
        MonodromyGroup larger = monodromy_group(loops.permutations());
        if (larger.is_symmetric() || (!at_first && group == larger))
            return LoopGroup{std::move(larger), loops.count()};
        group = std::move(larger);
    }
    return std::nullopt;
}

/// The same for the first of several images for which it succeeds: `solutions_at(seed)` gives the
/// solutions for those of a seed.
template <class SolutionsAt>
std::optional<LoopGroup> group_by_loops(std::uint64_t seed, const LoopProgress& progress,
                                        SolutionsAt solutions_at) {
    constexpr std::uint64_t most_images = 4;
    for (std::uint64_t attempt = 0; attempt < most_images; ++attempt) {
        auto solutions = solutions_at(most_images * seed + attempt);
        if (!solutions.complete()) continue;
        if (auto group = symmetric_group_of(solutions, progress)) return group;
        LoopPermutations loops(std::move(solutions), progress);
        if (auto group = group_of(loops)) return group;
    }
    return std::nullopt;
}

} // namespace plprove
