#include "checker/conclusion/label_class.h"

#include "checker/problem/notation.h"

namespace checker {
/// Whether the line is known from its points, two of them, wherever it is seen.
static bool is_implied(const Problem& problem, const Line& line) {
    return line.points.size() == 2 && std::ranges::all_of(line.points, [&](std::size_t point) {
               return (line.seen_by & ~problem.points[point].seen_by) == 0;
           });
}

Problem without_implied_lines(const Problem& problem) {
    Problem result = problem;
    result.lines.clear();
    for (Point& point : result.points)
        point.lines.clear();
    for (const Line& line : problem.lines) {
        if (is_implied(problem, line)) continue;
        for (const std::size_t point : line.points)
            result.points[point].lines.push_back(result.lines.size());
        result.lines.push_back(line);
    }
    return result;
}

/// What views see of a point and the lines through it; none if a line has another point.
static std::optional<Feature> feature_of(const Problem& problem, const Point& point) {
    Feature feature{.point = point.seen_by};
    for (const std::size_t n : point.lines) {
        if (problem.lines[n].points.size() > 1) return std::nullopt;
        feature.pin[feature.pins++] = problem.lines[n].seen_by;
    }
    return feature;
}

static std::optional<Features> features_of(const Problem& problem) {
    Features list;
    for (const Point& point : problem.points) {
        const auto feature = feature_of(problem, point);
        if (!feature) return std::nullopt;
        list.push_back(*feature);
    }
    for (const Line& line : problem.lines)
        if (line.points.empty())
            list.push_back({.free_line = true, .pin = {line.seen_by}, .pins = 1});
    return list;
}

std::optional<Signature> label_class(const Problem& problem) {
    const bool in_three_views =
        problem.cameras == &calibrated_cameras && problem.views == all_views;
    const std::optional<Features> list = features_of(problem);
    if (!in_three_views || !list || surplus(problem) != 0) return std::nullopt;
    Signature signature{};
    for (const Feature& feature : *list) {
        const std::size_t index = index_of(feature);
        if (index == feature_count) return std::nullopt;
        ++signature[index];
    }
    return largest_relabeled(signature);
}

std::optional<std::size_t> class_of(const Classification& classes, const Problem& problem) {
    const std::optional<Signature> signature = label_class(problem);
    return signature ? std::optional(number_of(classes, *signature)) : std::nullopt;
}
} // namespace checker
