#include "prover/groups/cycle_types.h"

#include <algorithm>
#include <flint/ulong_extras.h>
#include <numeric>
#include <regex>
#include <set>

namespace plprove {

namespace {

/// How many points some of the cycles may have together; 0 for none of them.
std::set<int> sizes_of_unions(const CycleType& lengths) {
    std::set<int> sizes{0};
    for (const int length : lengths) {
        std::set<int> larger;
        for (const int size : sizes)
            larger.insert(size + length);
        sizes.merge(larger);
    }
    return sizes;
}

/// Whether a set of fewer points, but not of none, may be one of cycles of each permutation.
bool may_be_intransitive(const std::vector<CycleType>& cycle_types, int degree) {
    std::vector<std::set<int>> sizes;
    for (const CycleType& lengths : cycle_types)
        sizes.push_back(sizes_of_unions(lengths));
    for (int size = 1; size < degree; ++size)
        if (std::ranges::all_of(sizes, [&](const auto& own) { return own.contains(size); }))
            return true;
    return false;
}

/// Whether a cycle may run through n blocks, with as many points in each, where other cycles fill
/// up the blocks.
bool may_run_through(const CycleType& lengths, std::size_t cycle, int n, int block) {
    CycleType shares;
    for (std::size_t other = 0; other < lengths.size(); ++other)
        if (other != cycle && lengths[other] % n == 0) shares.push_back(lengths[other] / n);
    return sizes_of_unions(shares).contains(block - lengths[cycle] / n);
}

/// Whether a permutation with these cycles may permute blocks of so many points.
bool may_keep_blocks(const CycleType& lengths, int block) {
    for (std::size_t cycle = 0; cycle < lengths.size(); ++cycle) {
        bool possible = false;
        for (int n = 1; n <= lengths[cycle] && !possible; ++n)
            possible = lengths[cycle] % n == 0 && may_run_through(lengths, cycle, n, block);
        if (!possible) return false;
    }
    return true;
}

bool may_be_imprimitive(const std::vector<CycleType>& cycle_types, int degree) {
    for (int block = 2; block < degree; ++block) {
        const auto keeps = [&](const CycleType& lengths) {
            return may_keep_blocks(lengths, block);
        };
        if (degree % block == 0 && std::ranges::all_of(cycle_types, keeps)) return true;
    }
    return false;
}

/// Whether a power is a single cycle, of a prime length in this range.
bool has_single_cycle(const CycleType& lengths, int shortest, int longest) {
    return std::ranges::any_of(lengths, [&](int p) {
        if (p < shortest || p > longest || !n_is_prime(static_cast<ulong>(p))) return false;
        return std::ranges::count_if(lengths, [&](int length) { return length % p == 0; }) == 1;
    });
}

int points_of(const CycleType& lengths) {
    return std::accumulate(lengths.begin(), lengths.end(), 0);
}

bool has_even_sign(const CycleType& lengths) {
    return (points_of(lengths) - static_cast<int>(lengths.size())) % 2 == 0;
}

/// Looks at all choices of `size` places that begin with those that are chosen.
bool choose(std::size_t count, std::size_t size,
            const std::function<bool(const std::vector<std::size_t>&)>& shows,
            std::vector<std::size_t>& chosen) {
    if (chosen.size() == size) return shows(chosen);
    for (std::size_t next = chosen.empty() ? 0 : chosen.back() + 1; next < count; ++next) {
        chosen.push_back(next);
        if (choose(count, size, shows, chosen)) return true;
        chosen.pop_back();
    }
    return false;
}

constexpr int poses = 20, pose_matrices = 10; // of two views that share five points

} // namespace

std::string group_shown_by(const std::vector<CycleType>& cycle_types, int degree, bool transitive) {
    bool has_cycle = false, even = false, odd = false, differ = false;
    for (const CycleType& lengths : cycle_types) {
        has_cycle |= has_single_cycle(lengths, 2, std::max(3, degree - 3)); // Jordan's theorems
        differ |= lengths != cycle_types.front();
        (has_even_sign(lengths) ? even : odd) = true;
    }
    if (!has_cycle || !differ || may_be_imprimitive(cycle_types, degree)) return {};
    if (!transitive && may_be_intransitive(cycle_types, degree)) return {};
    return (even && odd ? "S" : ">=A") + std::to_string(degree);
}

std::string group_with_blocks(const std::vector<SharedCycles>& all, int degree) {
    const int matrices = points_of(all.front().matrices);
    std::vector<CycleType> of_matrices;
    const int third_cameras = degree / poses; // of each pose of two views with five points
    bool has_cycle = false;
    std::set<bool> signs, products;
    for (const SharedCycles& cycles : all) {
        if (points_of(cycles.matrices) != matrices) return {};
        of_matrices.push_back(cycles.matrices);
        // The third cameras of a pose are then permuted in all even ways.
        has_cycle |= has_single_cycle(cycles.solutions, third_cameras / 2 + 1, third_cameras - 3);
        signs.insert(has_even_sign(cycles.solutions));
        products.insert(has_even_sign(cycles.solutions) == has_even_sign(cycles.matrices));
    }
    if (signs.size() < 2 || products.size() < 2) return {};
    const std::string symmetric = "S" + std::to_string(matrices);
    if (2 * matrices == degree && matrices % 2 == 0 &&
        group_shown_by(of_matrices, matrices, true) == symmetric)
        return "S2 wr " + symmetric;
    if (matrices == pose_matrices && has_cycle)
        return "<S" + std::to_string(third_cameras) + " wr S2 wr S10";
    return {};
}

bool may_be_shown_with_blocks(const std::string& group) {
    static const std::regex shown("S2 wr S\\d+|<S\\d+ wr S2 wr S10");
    return std::regex_match(group, shown) && !group.starts_with("<S2 ");
}

std::vector<std::size_t>
fewest_that_show(std::size_t count, std::size_t most,
                 const std::function<bool(const std::vector<std::size_t>&)>& shows) {
    std::vector<std::size_t> chosen;
    for (std::size_t size = 2; size <= most; ++size)
        if (choose(count, size, shows, chosen)) return chosen;
    return {};
}

} // namespace plprove
