#include "prover/problem/signature.h"

#include <algorithm>
#include <numeric>

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

/// Lists the balanced signatures that represent their classes, in decreasing lexicographic order.
///
/// The permutations of the views permute the entries in consecutive blocks. After each block, a
/// permutation that makes the prefix larger rules the whole branch out, and one that makes it
/// smaller need not be looked at again further down: only the tied ones remain.
class ClassEnumerator {
public:
    ClassEnumerator() {
        std::ranges::transform(standard_features(), weights_.begin(), weight);
        std::size_t reached = 0; // how far the permutations take the entries so far
        for (std::size_t i = 0, begin = 0; i < feature_count; ++i) {
            for (std::size_t p = 0; p < permutation_count; ++p) {
                const std::size_t image = view_permutations()[p][i];
                source_[p][image] = i;
                reached = std::max(reached, image + 1);
            }
            if (reached != i + 1) continue;
            block_begin_[i + 1] = begin;
            begin = i + 1;
        }
    }

    std::vector<Signature> run() {
        append(0, camera_dimension, (1U << permutation_count) - 1);
        return std::move(classes_);
    }

private:
    static constexpr std::size_t permutation_count = 6;
    static constexpr std::size_t inside_a_block = feature_count;

    /// Those of the tied permutations that leave the block before `end` as it is; nothing where one
    /// makes it larger.
    std::optional<unsigned> still_tied(std::size_t end, unsigned tied) const {
        for (std::size_t p = 0; p < permutation_count; ++p) {
            if ((tied >> p & 1U) == 0) continue;
            for (std::size_t i = block_begin_[end]; i < end; ++i) {
                const std::uint8_t image = signature_[source_[p][i]];
                if (image > signature_[i]) return std::nullopt;
                if (image == signature_[i]) continue;
                tied &= ~(1U << p);
                break;
            }
        }
        return tied;
    }

    /// Appends the representatives with the first `index` entries of signature_ and weights that
    /// add up to `rest` in the remaining ones.
    void append(std::size_t index, int rest, unsigned tied) {
        if (block_begin_[index] != inside_a_block) {
            const auto remaining = still_tied(index, tied);
            if (!remaining) return;
            tied = *remaining;
        }
        if (index == feature_count) return classes_.push_back(signature_);
        // The last entry has to use up the rest.
        const int most = rest / weights_[index];
        const int least = index + 1 == feature_count ? most : 0;
        for (int count = most; count >= least; --count) {
            signature_[index] = static_cast<std::uint8_t>(count);
            append(index + 1, rest - count * weights_[index], tied);
        }
    }

    std::array<int, feature_count> weights_{};
    std::array<FeaturePermutation, 6> source_{};
    std::array<std::size_t, feature_count + 1> block_begin_ = [] {
        std::array<std::size_t, feature_count + 1> none{};
        none.fill(inside_a_block);
        return none;
    }();
    Signature signature_{};
    std::vector<Signature> classes_;
};

} // namespace

Features problem_of(const Signature& signature) {
    Features problem;
    problem.reserve(std::reduce(signature.begin(), signature.end(), std::size_t{0}));
    for (std::size_t i = 0; i < feature_count; ++i)
        problem.insert(problem.end(), signature[i], standard_features()[i]);
    return problem;
}

std::optional<Signature> signature_of(const Features& problem) {
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

KindCounts kind_counts(const Signature& signature) {
    // Where the kinds begin in the list of features, and its end.
    constexpr std::array<std::ptrdiff_t, 14> begin{0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 12, 18, 21, 27};
    KindCounts counts{};
    for (std::size_t i = 0; i < counts.size(); ++i)
        counts[i] =
            std::accumulate(signature.begin() + begin[i], signature.begin() + begin[i + 1], 0);
    return counts;
}

std::size_t class_number(const std::vector<Signature>& classes, const Signature& representative) {
    const auto found = std::ranges::lower_bound(classes, representative, std::greater{});
    return static_cast<std::size_t>(found - classes.begin());
}

const std::vector<Signature>& label_classes() {
    static const std::vector<Signature> classes = ClassEnumerator().run();
    return classes;
}

} // namespace plprove
