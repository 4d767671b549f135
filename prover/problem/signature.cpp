#include "prover/problem/signature.h"

#include <algorithm>

namespace plprove {

namespace {

using FeaturePermutation = std::array<std::size_t, feature_count>;

std::size_t index_of(const Feature& feature) {
    static const std::vector<Feature> canonical_features = [] {
        std::vector<Feature> list;
        for (const Feature& standard : standard_features())
            list.push_back(canonical(standard));
        return list;
    }();
    const auto found = std::ranges::find(canonical_features, canonical(feature));
    return static_cast<std::size_t>(found - canonical_features.begin());
}

/// For each permutation of the views, where it takes each of the 27 features.
const std::array<FeaturePermutation, 6>& view_permutations() {
    static const std::array<FeaturePermutation, 6> permutations = [] {
        std::array<FeaturePermutation, 6> result{};
        std::array<int, 3> views{0, 1, 2};
        for (FeaturePermutation& permutation : result) {
            for (std::size_t i = 0; i < feature_count; ++i)
                permutation[i] = index_of(relabel_views(standard_features()[i], views));
            std::ranges::next_permutation(views);
        }
        return result;
    }();
    return permutations;
}

Signature permuted(const Signature& signature, const FeaturePermutation& permutation) {
    Signature result{};
    for (std::size_t i = 0; i < feature_count; ++i)
        result[permutation[i]] = signature[i];
    return result;
}

/// Moves all features of the second kind of each pair to the first: among the signatures that
/// differ by the pairs, this is the largest.
template <std::size_t N>
Signature merged(Signature signature, const std::array<std::array<std::size_t, 2>, N>& pairs) {
    for (const auto& [first, second] : pairs) {
        signature[first] = static_cast<std::uint8_t>(signature[first] + signature[second]);
        signature[second] = 0;
    }
    return signature;
}

/// The largest signature that `merge` makes of the members of an orbit.
template <class Merge>
Signature representative_of(const std::array<Signature, 6>& orbit, Merge merge) {
    Signature largest{};
    for (const Signature& signature : orbit)
        largest = std::max(largest, merge(signature));
    return largest;
}

/// Whether no permutation of the views makes the first `size` entries larger. Assumes that the
/// permutations map these entries to themselves.
bool prefix_is_largest(const Signature& signature, std::size_t size) {
    return std::ranges::all_of(view_permutations(), [&](const FeaturePermutation& permutation) {
        Signature image{};
        for (std::size_t i = 0; i < size; ++i)
            image[permutation[i]] = signature[i];
        return image <= signature;
    });
}

/// The lengths at which to compare prefixes: where a block of entries ends that the permutations of
/// the views permute among themselves.
const std::array<bool, feature_count + 1>& ends_of_blocks() {
    static const std::array<bool, feature_count + 1> ends = [] {
        std::array<bool, feature_count + 1> result{};
        std::size_t reached = 0; // how far the permutations take the entries so far
        for (std::size_t i = 0; i < feature_count; ++i) {
            const bool fixed =
                reached <= i &&
                std::ranges::all_of(view_permutations(), [&](const auto& p) { return p[i] == i; });
            for (const FeaturePermutation& permutation : view_permutations())
                reached = std::max(reached, permutation[i] + 1);
            result[i + 1] = reached == i + 1 && !fixed;
        }
        return result;
    }();
    return ends;
}

/// Appends the representatives among the solutions that begin with the given first `index` entries
/// and whose remaining weights add up to `rest`, in decreasing lexicographic order. The entries
/// from `index` on are zero.
void append_classes(Signature& signature, std::size_t index, int rest,
                    const std::array<int, feature_count>& weights,
                    std::vector<Signature>& classes) {
    // A signature is the largest of its orbit only if its prefixes are: most of the tree is
    // cut here.
    if (ends_of_blocks()[index] && !prefix_is_largest(signature, index)) return;
    if (index == feature_count) {
        if (rest == 0) classes.push_back(signature);
        return;
    }
    // The last entry has to use up the rest.
    const int most = rest / weights[index];
    const int least = index + 1 == feature_count ? most : 0;
    for (int count = most; count >= least; --count) {
        signature[index] = static_cast<std::uint8_t>(count);
        append_classes(signature, index + 1, rest - count * weights[index], weights, classes);
    }
}

} // namespace

Problem problem_of(const Signature& signature) {
    Problem problem;
    for (std::size_t i = 0; i < feature_count; ++i)
        problem.insert(problem.end(), signature[i], standard_features()[i]);
    return problem;
}

std::optional<Signature> signature_of(const Problem& problem) {
    Signature signature{};
    for (const Feature& feature : problem) {
        const std::size_t index = index_of(feature);
        if (index == feature_count || signature[index] == UINT8_MAX) return std::nullopt;
        ++signature[index];
    }
    return signature;
}

std::array<Signature, 6> relabelings(const Signature& signature) {
    std::array<Signature, 6> result{};
    std::ranges::transform(view_permutations(), result.begin(), [&](const auto& permutation) {
        return permuted(signature, permutation);
    });
    return result;
}

Signature representative(const Signature& signature) {
    return std::ranges::max(relabelings(signature));
}

Signature swap_representative(const Signature& signature) {
    // Relabeling permutes the pairs, so that merging commutes with it up to the choice of a largest
    // member.
    return representative_of(relabelings(signature), [](const Signature& relabeled) {
        return merged(relabeled, swap_pairs);
    });
}

Signature constraint_representative(const Signature& signature) {
    return representative_of(relabelings(signature), [](const Signature& relabeled) {
        return merged(merged(relabeled, swap_pairs), exchange_pairs);
    });
}

std::size_t class_number(const std::vector<Signature>& classes, const Signature& representative) {
    const auto found = std::ranges::lower_bound(classes, representative, std::greater{});
    return static_cast<std::size_t>(found - classes.begin());
}

const std::vector<Signature>& label_classes() {
    static const std::vector<Signature> classes = [] {
        std::array<int, feature_count> weights{};
        std::ranges::transform(standard_features(), weights.begin(), weight);
        std::vector<Signature> list;
        Signature signature{};
        append_classes(signature, 0, camera_dimension, weights, list);
        return list;
    }();
    return classes;
}

} // namespace plprove
