// The label classes, enumerated once, and problems by their features.
#pragma once

#include "checker/counts/counts.h"

#include <doctest/doctest.h>

#include <map>
#include <string>
#include <string_view>

inline const checker::Classification& all_classes() {
    static const checker::Classification classes = checker::classify();
    return classes;
}

/// The number of the class whose representative has this notation.
inline std::size_t class_of(std::string_view problem) {
    static const std::map<std::string, std::size_t, std::less<>> numbers = [] {
        std::map<std::string, std::size_t, std::less<>> all;
        for (std::size_t n = 0; n < all_classes().representatives.size(); ++n)
            all[checker::notation(all_classes().representatives[n])] = n;
        return all;
    }();
    const auto place = numbers.find(problem);
    INFO(problem);
    REQUIRE(place != numbers.end());
    return place->second;
}

/// The signature with these counts of features, in the notation of the table.
inline checker::Signature signature_of(const std::map<std::string_view, unsigned>& counts) {
    checker::Signature signature{};
    for (const auto& [feature, count] : counts) {
        const std::size_t index = checker::index_of(feature);
        REQUIRE(index < checker::feature_count);
        signature[index] = count;
    }
    return signature;
}

inline checker::Signature permuted(const checker::Signature& signature,
                                   const checker::FeatureMap& map) {
    checker::Signature result{};
    for (std::size_t i = 0; i < signature.size(); ++i)
        result[i] = signature[map[i]];
    return result;
}

/// The swap as a permutation of the features.
inline checker::FeatureMap swap_of_features() {
    checker::FeatureMap swap{};
    for (std::size_t i = 0; i < swap.size(); ++i)
        swap[i] = i;
    for (std::size_t i = 0; i < swap.size(); ++i) {
        const std::size_t earlier = checker::earlier_of_swap[i];
        if (earlier == i) continue;
        swap[i] = earlier;
        swap[earlier] = i;
    }
    return swap;
}

/// What certificates for all classes prove, if they hold.
inline const checker::Verdicts& all_verdicts() {
    static const checker::Verdicts verdicts = [] {
        checker::Verdicts all;
        for (const checker::Signature& signature : all_classes().representatives)
            all.emplace_back(checker::obstruction(signature));
        return all;
    }();
    return verdicts;
}
