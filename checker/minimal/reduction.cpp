#include "checker/minimal/reduction.h"

#include <optional>
#include <utility>

namespace checker {
/// What a feature becomes; none if it goes.
using Result = std::optional<Feature>;

/// Whether two features differ at most by their spelling.
static bool same(const Feature& a, const Feature& b) {
    return a.free_line == b.free_line && a.pins == b.pins && a.point == b.point && a.pin == b.pin;
}

static Feature without_pin(Feature feature, unsigned pin) {
    std::rotate(feature.pin.begin() + pin, feature.pin.begin() + pin + 1, feature.pin.end());
    feature.pin.back() = 0;
    --feature.pins;
    return feature;
}

/// A pin's place among the views that see its point.
struct PinLook {
    int views = 0;           // how many see the pin
    bool with_point = false; // whether all these see its point, too
};

static PinLook look_of(const Feature& feature, unsigned pin) {
    const Views seen = feature.pin[pin];
    return {std::popcount(seen), (seen & ~feature.point) == 0};
}

/// The pin rules: a pin that so many views see, all of which see its point, is forgotten.
static bool forgets_pin(const Feature& feature, const Result& result, int views) {
    if (!result || feature.free_line) return false;
    for (unsigned pin = 0; pin < feature.pins; ++pin) {
        const PinLook look = look_of(feature, pin);
        const bool fits = look.views == views && look.with_point;
        if (fits && same(without_pin(feature, pin), *result)) return true;
    }
    return false;
}

/// Whether the result is the feature's only pin as a free line, seen alike.
static bool leaves_line(const Feature& feature, const Result& result) {
    const Feature line{.free_line = true, .pin = feature.pin, .pins = 1};
    return feature.pins == 1 && result && same(line, *result);
}

static bool unseen_point(const Feature& feature, const Result& result) {
    if (feature.point != 0 || feature.pins == 0) return false;
    for (unsigned pin = 0; pin < feature.pins; ++pin)
        if (feature.pin[pin] == 0) return false;
    return feature.pins == 1 ? leaves_line(feature, result) : !result;
}

static bool point_and_pin_in_three_views(const Feature& feature) {
    const Views without_point = feature.pin[0] & ~feature.point;
    return std::popcount(feature.point) == 1 && feature.pins == 1 &&
           std::popcount(without_point) == 1;
}

/// A point, seen by some view, one of whose pins is seen by a view that does not see the point, if
/// no pin is unseen or can be forgotten.
static bool point_and_pin_in_two_views(const Feature& feature) {
    if (feature.point == 0) return false;
    bool found = false;
    for (unsigned pin = 0; pin < feature.pins; ++pin) {
        const PinLook look = look_of(feature, pin);
        if (look.with_point) return false; // unseen, or seen once or twice with the point
        found = true;
    }
    return found;
}

/// Whether the rule turns the feature into the result: the table of section 7.
static bool applies(std::string_view rule, const Feature& feature, const Result& result,
                    unsigned views) {
    const int points = std::popcount(feature.point);
    const int lines = std::popcount(feature.pin[0]);
    if (feature.free_line) {
        if (result) return false;
        return (rule == "unseen-line" && lines == 0) ||
               (rule == "free-line" && (lines == 1 || lines == 2));
    }
    if (rule == "unseen-line") return forgets_pin(feature, result, 0);
    if (rule == "pin-seen-once") return forgets_pin(feature, result, 1);
    if (rule == "pin-seen-twice") return forgets_pin(feature, result, 2);
    if (rule == "unseen-point") return unseen_point(feature, result);
    if (rule == "bare-point") return !result && feature.pins == 0 && points <= 1;
    if (rule == "point-on-line")
        return views == 3 && points == 1 && lines == 3 && leaves_line(feature, result);
    if (rule == "point-and-pin")
        return !result && (views == 3 ? point_and_pin_in_three_views(feature)
                                      : point_and_pin_in_two_views(feature));
    return false;
}

Features reduce(Reader& reader, Features list, unsigned views) {
    while (reader.comes("reduce")) {
        reader.take("reduce");
        const auto position = static_cast<std::size_t>(reader.small_integer(1, 1000));
        const std::string_view rule = reader.word();
        const std::string_view word = reader.word();
        Result result;
        if (word != "nothing") result = read_feature(reader, word, views, section_1);
        if (position > list.size()) throw Refused("there is no feature ", position);
        Feature& feature = list[position - 1];
        if (!applies(rule, feature, result, views))
            throw Refused("this is no rule for ", feature.notation);
        if (result)
            feature = *result;
        else
            list.erase(list.begin() + std::ptrdiff_t(position - 1));
        reader.end_line();
    }
    return list;
}

/// The first view that sees the point also sees the dangling pins, those that one view sees.
static Feature lifted(Feature feature) {
    const Views first = feature.point & -feature.point;
    for (Views& pin : feature.pin)
        if (std::popcount(pin) == 1 && !feature.free_line) pin |= first;
    return feature;
}

static bool is_large_star(const Feature& feature) {
    const auto full = std::count(feature.pin.begin(), feature.pin.end(), all_views);
    return feature.pins > 7 && feature.point == all_views && std::cmp_equal(full, feature.pins);
}

Lifted lift(const Features& list, unsigned views) {
    Lifted result;
    Features large_stars;
    std::array<Features, feature_count> others{};
    for (const Feature& reduced : list) {
        Feature feature = lifted(reduced);
        if (views == 3 && is_large_star(feature)) {
            result.large_star = true;
            result.weight += 3 + feature.pins;
            large_stars.push_back(feature);
            continue;
        }
        const std::size_t index = index_of(feature);
        const bool shared_point = feature.point == 0b011 && feature.pins == 0;
        if (views == 2 ? !shared_point : index == feature_count)
            throw Refused("a rule still applies to ", feature.notation);
        feature.equations = features[index].equations; // more, if it was lifted
        result.weight += features[index].weight();
        ++result.signature[index];
        others[index].push_back(feature);
    }
    result.features = large_stars;
    for (const Features& same_index : others)
        result.features.insert(result.features.end(), same_index.begin(), same_index.end());
    return result;
}
} // namespace checker
