#include "prover/catalogue/spelling.h"

#include "prover/problem/reduction.h"

#include <algorithm>

namespace plprove {

namespace {

using FeatureNames = std::array<std::string, feature_count>;

/// The sum of the features with these names; equal neighbours (a swap pair's) are counted together.
std::string sum(const Signature& signature, const FeatureNames& names) {
    std::string text;
    for (std::size_t i = 0; i < feature_count;) {
        int count = signature[i];
        std::size_t next = i + 1;
        for (; next < feature_count && names[next] == names[i]; ++next)
            count += signature[next];
        if (count > 0) {
            if (!text.empty()) text += " + ";
            if (count > 1) text += std::to_string(count) + "*";
            text += names[i];
        }
        i = next;
    }
    return text;
}

template <class Form>
FeatureNames names_of(Form form) {
    FeatureNames names;
    std::ranges::transform(standard_features(), names.begin(),
                           [&](const Feature& feature) { return notation(form(feature)); });
    return names;
}

} // namespace

std::string notation(const Signature& signature) {
    static const FeatureNames names = names_of([](const Feature& feature) { return feature; });
    return sum(signature, names);
}

std::string terminal_notation(const Signature& signature) {
    static const FeatureNames names =
        names_of([](const Feature& feature) { return terminal(feature); });
    return sum(signature, names);
}

} // namespace plprove
