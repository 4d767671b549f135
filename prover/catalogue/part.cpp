#include "prover/catalogue/part.h"

#include "prover/problem/reduction.h"
#include "prover/problem/spec.h"

#include <algorithm>

namespace plprove {

namespace {

/// The index of the feature, once its dangling pins are fixed. Throws NotationError.
std::size_t index_of(const Feature& feature) {
    const bool can_be_lifted = feature.views() == 3 && !reduce_once(feature);
    const auto signature = can_be_lifted ? signature_of({lifted(feature)}) : std::nullopt;
    if (!signature)
        throw NotationError(notation(feature) +
                            " is none of the 27 features of label classes: write features of "
                            "certs/FORMAT.md, section 1, such as P/P/P or Pa/Pa/a");
    return static_cast<std::size_t>(std::ranges::find(*signature, 1) - signature->begin());
}

/// Of each pair, how many features there are.
std::array<int, swap_pairs.size()> pair_counts(const Signature& signature) {
    std::array<int, swap_pairs.size()> counts{};
    for (std::size_t i = 0; i < counts.size(); ++i)
        counts[i] = signature[swap_pairs[i][0]] + signature[swap_pairs[i][1]];
    return counts;
}

bool is_in_a_pair(std::size_t index) {
    return std::ranges::any_of(swap_pairs, [&](const std::array<std::size_t, 2>& pair) {
        return pair[0] == index || pair[1] == index;
    });
}

} // namespace

std::vector<Part> parse_part(std::string_view spec) {
    Signature fixed{};
    Signature dangling{};
    for (const Feature& feature : parse_spec(spec)) {
        const std::size_t index = index_of(feature);
        const bool stands_for_either = lifted(feature) != feature && is_in_a_pair(index);
        std::uint8_t& count = stands_for_either ? dangling[index] : fixed[index];
        if (count == UINT8_MAX)
            throw NotationError("too many features: write at most 255 of a kind");
        ++count;
    }
    const auto images_of_fixed = relabelings(fixed);
    const auto images_of_dangling = relabelings(dangling);
    std::vector<Part> images;
    for (std::size_t i = 0; i < images_of_fixed.size(); ++i)
        images.push_back({images_of_fixed[i], pair_counts(images_of_dangling[i])});
    return images;
}

bool contains(const Signature& problem, const Part& part) {
    for (std::size_t i = 0; i < feature_count; ++i)
        if (problem[i] < part.fixed[i]) return false;
    const auto has = pair_counts(problem);
    const auto needs = pair_counts(part.fixed);
    for (std::size_t i = 0; i < has.size(); ++i)
        if (has[i] < needs[i] + part.either[i]) return false;
    return true;
}

bool is_contained(const Signature& problem, const Part& part) {
    std::array<int, swap_pairs.size()> beyond{};
    for (std::size_t i = 0; i < feature_count; ++i) {
        if (problem[i] <= part.fixed[i]) continue;
        if (!is_in_a_pair(i)) return false;
        for (std::size_t pair = 0; pair < swap_pairs.size(); ++pair)
            if (std::ranges::find(swap_pairs[pair], i) != swap_pairs[pair].end())
                beyond[pair] += problem[i] - part.fixed[i];
    }
    for (std::size_t pair = 0; pair < beyond.size(); ++pair)
        if (beyond[pair] > part.either[pair]) return false;
    return true;
}

} // namespace plprove
