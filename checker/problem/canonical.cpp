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

/// Whether the line is known from its points, two of them, wherever it is seen.
static bool is_implied(const Problem& problem, const Line& line) {
    return line.points.size() == 2 && std::ranges::all_of(line.points, [&](std::size_t point) {
               return (line.seen_by & ~problem.points[point].seen_by) == 0;
           });
}

std::optional<CanonicalProblem> canonical(const Problem& problem) {
    if (problem.cameras != &calibrated_cameras) return std::nullopt;
    CanonicalProblem result{.views = static_cast<unsigned>(problem.view_count())};
    for (const Line& line : problem.lines) {
        if (line.points.size() > 1 && !is_implied(problem, line)) return std::nullopt;
        if (line.points.empty()) ++result.features[{.free_line = true, .pins = {line.seen_by}}];
    }
    for (const Point& point : problem.points) {
        CanonicalFeature seen{.point = point.seen_by};
        for (const std::size_t line : point.lines)
            if (problem.lines[line].points.size() == 1)
                seen.pins.push_back(problem.lines[line].seen_by);
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
