#include "checker/conclusion/group.h"

#include "checker/conclusion/pages_of_theorems.h"

#include <algorithm>

namespace checker {
namespace {
bool takes_both_values(const std::vector<BlockCycles>& all, const auto& sign) {
    return std::ranges::any_of(all, sign) && !std::ranges::all_of(all, sign);
}

/// Whether a power is one cycle, so long that by a theorem of Jordan a transitive group of so many
/// points with it contains all even permutations.
bool has_long_cycle(const CycleType& lengths, std::size_t points) {
    return points > 3 && has_prime_cycle(lengths, points / 2 + 1, points - 3);
}

bool has_blocks(const std::string& group) {
    return group.find(" wr ") != std::string::npos;
}

/// With so many third cameras for each pose of two views that share five points.
std::string group_of_third_cameras(std::size_t count) {
    if (count == 1) return std::string(group_of_five_points);
    return say("<S", count, " wr ", group_of_five_points.substr(1));
}

/// The group of so many solutions that share essential matrices, if its permutations have cycles
/// like these (proofs/shared_matrices.md, Theorem 3); empty if they do not show it.
std::string group_with_blocks(std::vector<BlockCycles> all, std::size_t solutions) {
    std::size_t blocks = 0;
    for (const BlockCycles& cycles : all)
        blocks = std::max(blocks, points_of(cycles.matrices));
    std::erase_if(all, [&](const BlockCycles& cycles) {
        return points_of(cycles.solutions) != solutions || points_of(cycles.matrices) != blocks;
    });
    const auto first_sign = [](const BlockCycles& cycles) { return is_even(cycles.solutions); };
    const auto both_signs = [](const BlockCycles& cycles) {
        return is_even(cycles.solutions) == is_even(cycles.matrices);
    };
    if (!takes_both_values(all, first_sign) || !takes_both_values(all, both_signs)) return {};
    std::vector<CycleType> of_matrices;
    for (const BlockCycles& cycles : all)
        of_matrices.push_back(cycles.matrices);
    const std::string of_blocks = say("S", blocks);
    if (2 * blocks == solutions && blocks % 2 == 0 &&
        group_shown_by(of_matrices, blocks, Orbits::one) == of_blocks)
        return "S2 wr " + of_blocks;
    const std::size_t third_cameras = solutions / 20; // of each pose of two views with five points
    if (blocks == 10 && std::ranges::any_of(all, [&](const BlockCycles& cycles) {
            return has_long_cycle(cycles.solutions, third_cameras);
        }))
        return group_of_third_cameras(third_cameras);
    return {};
}
} // namespace

std::string group_of(const DegreeBounds& bounds) {
    if (!bounds.exact()) return {};
    const std::size_t degree = bounds.at_least;
    if (bounds.group_theorem == theorem_of_permutations) return say("S", degree);
    if (bounds.group_theorem == theorem_of_five_points) return group_of_third_cameras(degree / 20);
    const std::string group = group_shown_by(bounds.cycle_types, degree, Orbits::one);
    return group.empty() ? group_with_blocks(bounds.block_cycles, degree) : group;
}

std::string source_of_group(const DegreeBounds& bounds) {
    if (bounds.group_theorem.empty())
        return has_blocks(group_of(bounds)) ? "by fibres: proofs/shared_matrices.md"
                                            : "by fibres: proofs/fibres.md";
    return say("by Theorem ", bounds.group_theorem, " of proofs/", page_of(bounds.group_theorem));
}

bool implies_group(const std::string& known, const std::string& expected) {
    if (known.empty()) return false;
    const auto degree = [](const std::string& group) {
        return group.substr(group.find_first_of("AS") + 1);
    };
    return known == expected || (known.starts_with('S') && expected.starts_with(">=A") &&
                                 degree(known) == degree(expected));
}
} // namespace checker
