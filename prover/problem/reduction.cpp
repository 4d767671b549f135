#include "prover/problem/reduction.h"

#include "prover/problem/signature.h"

#include <algorithm>
#include <array>

namespace plprove {

namespace {

/// The views that see a line of the feature, counted with and without its point.
struct LineViews {
    int seen = 0;
    int with_point = 0;
};

LineViews views_of_line(const Feature& feature, int line) {
    LineViews views;
    for (int view = 0; view < feature.views(); ++view) {
        views.seen += feature.sees_line(view, line);
        views.with_point += feature.sees_line(view, line) && feature.sees_point(view);
    }
    return views;
}

int views_of_point(const Feature& feature) {
    return static_cast<int>(std::ranges::count_if(feature.sights, &Sight::point));
}

/// The point without this pin; the pins after it move up in the alphabet.
Feature without_pin(const Feature& feature, int line) {
    Feature result = feature;
    --result.lines;
    const std::uint32_t before = (1U << line) - 1;
    for (Sight& sight : result.sights)
        sight.pins = (sight.pins & before) | (sight.pins >> 1 & ~before);
    return result;
}

ReductionStep forget(Rule rule, const Feature& feature) {
    return {rule, 0, feature, std::nullopt};
}

std::optional<ReductionStep> forget_a_line(const Feature& feature) {
    for (int line = 0; line < feature.lines; ++line) {
        const LineViews views = views_of_line(feature, line);
        if (!feature.has_point) {
            if (views.seen == 0) return forget(Rule::unseen_line, feature);
            if (views.seen <= 2) return forget(Rule::free_line, feature);
            continue;
        }
        std::optional<Rule> rule;
        if (views.seen == 0) rule = Rule::unseen_line;
        if (views.seen == 1 && views.with_point == 1) rule = Rule::pin_seen_once;
        if (views.seen == 2 && views.with_point == 2) rule = Rule::pin_seen_twice;
        if (rule) return ReductionStep{*rule, 0, feature, without_pin(feature, line)};
    }
    return std::nullopt;
}

Feature as_free_line(const Feature& feature) {
    Feature line = feature;
    line.has_point = false;
    for (Sight& sight : line.sights)
        sight.point = false;
    return line;
}

/// A point with one pin, none of whose lines can be forgotten alone: three views.
std::optional<ReductionStep> reduce_point_with_pin(const Feature& feature) {
    const LineViews line = views_of_line(feature, 0);
    if (views_of_point(feature) != 1) return std::nullopt;
    if (line.seen == 3)
        return ReductionStep{Rule::point_on_line, 0, feature, as_free_line(feature)};
    // Seen as P/a/- or Pa/a/-. What remains, P/a/a, is a condition on the cameras.
    if (line.seen == 1 || line.with_point == 1) return forget(Rule::point_and_pin, feature);
    return std::nullopt;
}

bool some_view_sees_only_a_pin(const Feature& feature) {
    return std::ranges::any_of(feature.sights,
                               [](const Sight& sight) { return !sight.point && sight.pins != 0; });
}

struct RuleText {
    std::string_view name;
    std::string_view explanation;
};

/// In the order of Rule.
constexpr std::array<RuleText, 8> rule_texts{{
    {"unseen-line", "a line that no view sees is forgotten (Theorem 7)"},
    {"pin-seen-once", "a pin seen by one view, which sees its point too, is forgotten (Theorem 7)"},
    {"pin-seen-twice",
     "a pin seen by two views, which both see its point, is forgotten (Theorem 2)"},
    {"free-line", "a free line seen by at most two views is forgotten (Theorems 2 and 7)"},
    {"unseen-point",
     "a point that no view sees is forgotten: with one pin it leaves a free line, with more it "
     "takes them along (Theorem 7)"},
    {"bare-point", "a point without pins that at most one view sees is forgotten (Theorem 7)"},
    {"point-on-line",
     "a point seen by one view, with a pin seen by all three, leaves a free line (Theorem 2)"},
    {"point-and-pin",
     "a point is forgotten with its pins: as they are seen, the cameras determine no less without "
     "them (Theorems 2 and 7; two views: supplementary note)"},
}};

} // namespace

std::string_view name(Rule rule) {
    return rule_texts.at(static_cast<std::size_t>(rule)).name;
}

std::string_view explanation(Rule rule) {
    return rule_texts.at(static_cast<std::size_t>(rule)).explanation;
}

std::optional<ReductionStep> reduce_once(const Feature& feature) {
    if (auto step = forget_a_line(feature)) return step;
    if (!feature.has_point) return std::nullopt;
    if (!point_is_seen(feature) && feature.lines > 0) {
        if (feature.lines == 1)
            return ReductionStep{Rule::unseen_point, 0, feature, as_free_line(feature)};
        return forget(Rule::unseen_point, feature);
    }
    if (feature.lines == 0)
        return views_of_point(feature) <= 1 ? std::optional(forget(Rule::bare_point, feature))
                                            : std::nullopt;
    if (feature.views() == 2)
        return some_view_sees_only_a_pin(feature)
                   ? std::optional(forget(Rule::point_and_pin, feature))
                   : std::nullopt;
    return feature.lines == 1 ? reduce_point_with_pin(feature) : std::nullopt;
}

Reduction reduce(const Features& problem) {
    Reduction reduction;
    for (const Feature& feature : problem) {
        std::optional<Feature> current = feature;
        while (current) {
            auto step = reduce_once(*current);
            if (!step) break;
            step->position = reduction.reduced.size();
            current = step->after;
            reduction.steps.push_back(std::move(*step));
        }
        if (current) reduction.reduced.push_back(std::move(*current));
    }
    return reduction;
}

Feature lifted(const Feature& reduced) {
    Feature result = reduced;
    for (int line = 0; line < reduced.lines && reduced.has_point; ++line) {
        if (views_of_line(reduced, line).seen != 1) continue;
        // A dangling pin. In P/P/a the first view that sees the point fixes it; in P/b/a the only
        // one does.
        const auto view = std::ranges::find_if(result.sights, &Sight::point);
        view->pins |= 1U << line;
    }
    return result;
}

Feature terminal(const Feature& reduced) {
    const Feature full = lifted(reduced);
    const auto signature = signature_of({full});
    if (!signature) return reduced;
    constexpr std::size_t first_with_dangling = 12;
    constexpr std::size_t last_with_one_pin = 17;
    constexpr std::size_t first_with_two_pins = 24;
    const auto index =
        static_cast<std::size_t>(std::ranges::find(*signature, 1) - signature->begin());
    if (index < first_with_dangling || (index > last_with_one_pin && index < first_with_two_pins))
        return full;
    Feature result = full;
    for (Sight& sight : result.sights)
        if (sight.point) sight.pins = 0;
    return result;
}

namespace {

template <class Transform>
Features transformed(const Features& reduced, Transform transform) {
    Features problem;
    for (const Feature& feature : reduced)
        problem.push_back(transform(feature));
    const auto index = [](const Feature& feature) {
        const auto signature = signature_of({lifted(feature)});
        return signature ? std::ranges::find(*signature, 1) - signature->begin() : -1;
    };
    std::ranges::stable_sort(problem, {}, index);
    return problem;
}

} // namespace

Features lifted(const Features& reduced) {
    return transformed(reduced, [](const Feature& feature) { return lifted(feature); });
}

Features terminal(const Features& reduced) {
    return transformed(reduced, [](const Feature& feature) { return terminal(feature); });
}

} // namespace plprove
