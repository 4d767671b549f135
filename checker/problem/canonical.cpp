#include "checker/problem/canonical.h"

namespace checker {
CanonicalProblem canonical(unsigned views, const Features& list) {
    CanonicalProblem result{.views = views};
    for (const Feature& feature : list) {
        CanonicalFeature seen{.free_line = feature.free_line, .point = feature.point};
        seen.pins.assign(feature.pin.begin(), feature.pin.begin() + feature.pins);
        std::ranges::sort(seen.pins);
        ++result.features[seen];
    }
    return result;
}

static std::size_t index_of(const CanonicalFeature& canonical) {
    Feature feature{.free_line = canonical.free_line, .point = canonical.point};
    std::ranges::copy(canonical.pins, feature.pin.begin());
    feature.pins = static_cast<unsigned>(canonical.pins.size());
    return index_of(feature);
}

std::optional<std::size_t> class_of(const Classification& classes,
                                    const CanonicalProblem& problem) {
    if (problem.views != 3) return std::nullopt;
    Signature signature{};
    unsigned weight = 0;
    for (const auto& [feature, count] : problem.features) {
        const std::size_t index = index_of(feature);
        if (index == feature_count) return std::nullopt;
        signature[index] += count;
        weight += count * features[index].weight();
    }
    if (weight != camera_unknowns) return std::nullopt;
    return number_of(classes, largest_relabeled(signature));
}
} // namespace checker
