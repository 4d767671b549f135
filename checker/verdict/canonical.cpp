#include "checker/verdict/canonical.h"

namespace checker {
CanonicalProblem canonical(const Problem& problem) {
    CanonicalProblem result{.views = problem.views};
    for (const Feature& feature : problem.features) {
        CanonicalFeature seen{.free_line = feature.free_line, .point = feature.point};
        seen.pins.assign(feature.pin.begin(), feature.pin.begin() + feature.pins);
        std::ranges::sort(seen.pins);
        ++result.features[seen];
    }
    return result;
}

/// The index of the feature in the table; none if it is not there.
static std::optional<std::size_t> index_of(const CanonicalFeature& feature) {
    Pins pins{};
    std::ranges::copy(feature.pins, pins.begin());
    const std::size_t index = index_of(feature.point, pins);
    if (index == feature_count) return std::nullopt;
    const Feature& found = features[index];
    const bool same = found.free_line == feature.free_line && found.pins == feature.pins.size();
    return same ? std::optional(index) : std::nullopt;
}

std::optional<std::size_t> class_of(const Classification& classes,
                                    const CanonicalProblem& problem) {
    if (problem.views != 3) return std::nullopt;
    Signature signature{};
    unsigned weight = 0;
    for (const auto& [feature, count] : problem.features) {
        const std::optional<std::size_t> index = index_of(feature);
        if (!index) return std::nullopt;
        signature[*index] += count;
        weight += count * features[*index].weight();
    }
    if (weight != camera_unknowns) return std::nullopt;
    return number_of(classes, largest_relabeled(signature));
}
} // namespace checker
