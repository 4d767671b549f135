#include "prover/minimal/extensions.h"

#include "prover/problem/reduction.h"

#include <algorithm>
#include <bit>
#include <set>

namespace plprove {

namespace {

using FeatureSet = std::set<Feature>;

/// The feature with one line more, in all ways in which views may see it: of two pins, a view sees
/// the point as well.
FeatureSet with_a_line(const Feature& feature) {
    FeatureSet result;
    for (std::uint32_t views = 0; views < 1U << feature.views(); ++views) {
        Feature next = feature;
        bool possible = true;
        for (std::uint32_t view = 0; view < next.sights.size(); ++view) {
            Sight& sight = next.sights[view];
            if ((views >> view & 1U) != 0) sight.pins |= 1U << feature.lines;
            if (std::popcount(sight.pins) > 1 && !sight.point) possible = false;
        }
        ++next.lines;
        if (possible) result.insert(canonical(next));
    }
    return result;
}

/// The feature with a point, in all ways in which views may see it.
FeatureSet with_a_point(const Feature& feature) {
    FeatureSet result;
    for (std::uint32_t views = 0; views < 1U << feature.views(); ++views) {
        Feature next = feature;
        next.has_point = true;
        for (std::uint32_t view = 0; view < next.sights.size(); ++view)
            next.sights[view].point = (views >> view & 1U) != 0;
        result.insert(canonical(next));
    }
    return result;
}

/// Free lines, points, and points with a pin.
FeatureSet small_features(int views) {
    const Feature nothing{false, 0, std::vector<Sight>(static_cast<std::size_t>(views))};
    FeatureSet result = with_a_line(nothing);
    for (const Feature& point : with_a_point(nothing)) {
        result.insert(point);
        result.merge(with_a_line(point));
    }
    return result;
}

/// Whether one step of the reduction leaves `rest` of the feature.
bool is_reduced_to(const Feature& feature, const std::optional<Feature>& rest) {
    const std::optional<ReductionStep> step = reduce_once(feature);
    if (!step || step->after.has_value() != rest.has_value()) return false;
    return !rest || canonical(*step->after) == canonical(*rest);
}

} // namespace

std::vector<Change> extensions(const Features& problem) {
    std::vector<Change> result;
    for (const Feature& added : small_features(problem.front().views()))
        if (weight(added) == 0 && is_reduced_to(added, std::nullopt))
            result.push_back({std::nullopt, added});
    for (const Feature& feature : FeatureSet(problem.begin(), problem.end())) {
        const FeatureSet larger = feature.has_point ? with_a_line(feature) : with_a_point(feature);
        for (const Feature& added : larger)
            if (weight(added) == weight(feature) && is_reduced_to(added, feature))
                result.push_back({feature, added});
    }
    return result;
}

} // namespace plprove
