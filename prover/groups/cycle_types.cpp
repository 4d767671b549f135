#include "prover/groups/cycle_types.h"

#include "prover/groups/jordan.h"

#include <algorithm>
#include <set>

namespace plprove {

namespace {

/// How many points some of the cycles may have together.
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

bool has_even_sign(const CycleType& lengths, int degree) {
    return (degree - static_cast<int>(lengths.size())) % 2 == 0;
}

/// Looks at all choices of `count` cycle types that begin with those that are chosen.
bool choose(const std::string& group, const std::vector<CycleType>& cycle_types, int degree,
            std::size_t count, std::vector<std::size_t>& chosen) {
    if (chosen.size() == count) {
        std::vector<CycleType> own;
        for (const std::size_t place : chosen)
            own.push_back(cycle_types[place]);
        return group_shown_by(own, degree) == group;
    }
    for (std::size_t next = chosen.empty() ? 0 : chosen.back() + 1; next < cycle_types.size();
         ++next) {
        chosen.push_back(next);
        if (choose(group, cycle_types, degree, count, chosen)) return true;
        chosen.pop_back();
    }
    return false;
}

} // namespace

std::string group_shown_by(const std::vector<CycleType>& cycle_types, int degree) {
    bool has_cycle = false, even = false, odd = false;
    for (const CycleType& lengths : cycle_types) {
        for (const int length : lengths)
            has_cycle |= shows_alternating(degree, length);
        (has_even_sign(lengths, degree) ? even : odd) = true;
    }
    if (!has_cycle || may_be_intransitive(cycle_types, degree)) return {};
    return (even && odd ? "S" : ">=A") + std::to_string(degree);
}

std::vector<std::size_t> fewest_that_show(const std::string& group,
                                          const std::vector<CycleType>& cycle_types, int degree,
                                          std::size_t most) {
    std::vector<std::size_t> chosen;
    for (std::size_t count = 2; count <= most; ++count)
        if (choose(group, cycle_types, degree, count, chosen)) return chosen;
    return {};
}

} // namespace plprove
