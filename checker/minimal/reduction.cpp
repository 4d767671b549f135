#include "checker/minimal/reduction.h"

#include <optional>
#include <utility>

namespace checker {
static Feature without_pin(Feature feature, unsigned pin) {
    std::rotate(feature.pin.begin() + pin, feature.pin.begin() + pin + 1, feature.pin.end());
    feature.pin.back() = 0;
    --feature.pins;
    return feature;
}

/// The only pin as a free line, seen alike.
static Feature as_line(const Feature& feature) {
    return {.free_line = true, .pin = feature.pin, .pins = 1};
}

/// Whether exactly `views` views see the pin, and see its point, too.
static bool is_forgotten(const Feature& point, Views pin, int views) {
    return std::popcount(pin) == views && (pin & ~point.point) == 0;
}

static bool no_view_sees_point_but_all_pins(const Feature& point) {
    const auto end = point.pin.begin() + point.pins;
    return point.point == 0 && std::find(point.pin.begin(), end, 0U) == end;
}

/// Whether a view that does not see the point sees each pin.
static bool each_pin_is_seen_alone(const Feature& point) {
    return std::all_of(point.pin.begin(), point.pin.begin() + point.pins,
                       [&](Views pin) { return (pin & ~point.point) != 0; });
}

enum class Of { line, point };                 // what a rule is about
enum class Leaves { nothing, the_line, rest }; // rest: the point without the pin

/// A rule of section 7.
struct Rule {
    std::string_view name;
    unsigned views; // in which it holds; 0 in two and in three
    Of of;
    /// Whether it applies to the feature and, if it leaves the rest, to this pin of it.
    bool (*applies)(const Feature& feature, Views pin);
    Leaves leaves;
};

/// The table of section 7.
constexpr std::array<Rule, 11> rules{
    {{"unseen-line", 0, Of::line, [](auto&, Views line) { return line == 0; }, Leaves::nothing},
     {"unseen-line", 0, Of::point, [](auto&, Views pin) { return pin == 0; }, Leaves::rest},
     {"free-line", 0, Of::line,
      [](auto&, Views line) { return line != 0 && std::popcount(line) <= 2; }, Leaves::nothing},
     {"pin-seen-once", 0, Of::point,
      [](auto& point, Views pin) { return is_forgotten(point, pin, 1); }, Leaves::rest},
     {"pin-seen-twice", 0, Of::point,
      [](auto& point, Views pin) { return is_forgotten(point, pin, 2); }, Leaves::rest},
     {"unseen-point", 0, Of::point,
      [](auto& point, Views) { return point.pins == 1 && no_view_sees_point_but_all_pins(point); },
      Leaves::the_line},
     {"unseen-point", 0, Of::point,
      [](auto& point, Views) { return point.pins > 1 && no_view_sees_point_but_all_pins(point); },
      Leaves::nothing},
     {"bare-point", 0, Of::point,
      [](auto& point, Views) { return point.pins == 0 && std::popcount(point.point) <= 1; },
      Leaves::nothing},
     {"point-on-line", 3, Of::point,
      [](auto& point, Views pin) {
          return point.pins == 1 && std::popcount(point.point) == 1 && pin == all_views;
      },
      Leaves::the_line},
     {"point-and-pin", 3, Of::point,
      [](auto& point, Views pin) {
          return point.pins == 1 && std::popcount(point.point) == 1 &&
                 std::popcount(pin & ~point.point) == 1;
      },
      Leaves::nothing},
     {"point-and-pin", 2, Of::point,
      [](auto& point, Views) {
          return point.point != 0 && point.pins > 0 && each_pin_is_seen_alone(point);
      },
      Leaves::nothing}}};

/// What a feature becomes; none if it goes.
using Result = std::optional<Feature>;

/// Whether two features differ at most by the names of their pins.
static bool same(const Feature& a, const Result& b) {
    return b && a.free_line == b->free_line && a.point == b->point && a.pins == b->pins &&
           a.pin == b->pin;
}

/// Whether the rule turns the feature into the result.
static bool turns(const Rule& rule, const Feature& feature, const Result& result) {
    if (rule.leaves != Leaves::rest) {
        if (!rule.applies(feature, feature.pin[0])) return false;
        return rule.leaves == Leaves::nothing ? !result : same(as_line(feature), result);
    }
    for (unsigned pin = 0; pin < feature.pins; ++pin)
        if (rule.applies(feature, feature.pin[pin]) && same(without_pin(feature, pin), result))
            return true;
    return false;
}

/// Whether a rule of this name turns the feature into the result.
static bool applies(std::string_view name, const Feature& feature, const Result& result,
                    unsigned views) {
    const Of of = feature.free_line ? Of::line : Of::point;
    return std::ranges::any_of(rules, [&](const Rule& rule) {
        return rule.name == name && rule.of == of && (rule.views == 0 || rule.views == views) &&
               turns(rule, feature, result);
    });
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
