// The bounds that are theorems: the tables against the statements of the theorems of
// proofs/three_views, chapter 6, as the checker has them. Theorem C has rows for what Theorems U15,
// U17 and Y state, too, but for one of these.
#include "checker/bounds/theorems.h"
#include "tests/checker/bounds/templates.h"

#include <fstream>
#include <regex>
#include <set>

using namespace checker;
using namespace templates;

namespace {
/// What the theorems ask of a problem.
struct Traits {
    unsigned points = 0;         // that all three views see
    unsigned pins = 0;           // of these points together
    unsigned most_pins = 0;      // of one of them
    unsigned lines = 0;          // that all views see: free ones and pins
    unsigned free_lines = 0;     //
    unsigned twice_seen = 0;     // points that just two views see
    bool twice_seen_pin = false; // whether one of these has a pin
    bool hidden = false;         // whether a view misses something
    unsigned same_two_views = 0; // the most points that two views see beside those of all views
    /// Of each point that one view or two see, the view that alone does, or alone does not.
    Views distinguished{};
};

Traits traits_of(const Signature& signature) {
    Traits found;
    for (std::size_t i = 0; i < feature_count; ++i) {
        const Feature& feature = features[i];
        const unsigned count = signature[i];
        if (count == 0) continue;
        const int seen_by = std::popcount(feature.point);
        const auto pins_of_all =
            static_cast<unsigned>(std::count(feature.pin.begin(), feature.pin.end(), all_views));
        found.lines += count * pins_of_all;
        if (feature.free_line) found.free_lines += count;
        found.hidden |= !feature.free_line && (seen_by < 3 || pins_of_all < feature.pins);
        if (seen_by == 3) {
            found.points += count;
            found.pins += count * feature.pins;
            found.most_pins = std::max(found.most_pins, feature.pins);
        }
        if (seen_by == 2) {
            found.twice_seen += count;
            found.twice_seen_pin |= feature.pins > 0;
            found.distinguished |= all_views & ~feature.point;
        }
        if (seen_by == 1) found.distinguished |= feature.point;
    }
    for (const Views pair : view_pairs)
        found.same_two_views =
            std::max(found.same_two_views, shared_points(signature, pair) - found.points);
    return found;
}

/// Theorems U8 and U11: of a point that all views see, the lines are its pins and those to the
/// other points that all views see. 0 if they say nothing.
unsigned bound_by_lines_through_a_point(const Traits& t) {
    if (t.points == 0) return 0;
    const unsigned lines = t.most_pins + t.points - 1;
    if (lines >= 6) return 64;
    if (lines < 5) return 0;
    const bool another_line = t.lines > t.most_pins; // not through the point
    if (another_line) return 240;
    if (t.points == 2 && t.twice_seen > 0) return 240;
    if (t.points == 2) return 272;
    if (t.same_two_views >= 2) return 272;
    return t.twice_seen >= 2 && t.twice_seen_pin ? 272 : 0;
}

/// Theorem U15: three points that all views see, and what weighs 2 beside them.
unsigned bound_by_three_points(const Traits& t) {
    if (t.pins == 2) return t.most_pins == 2 ? 224 : 312;
    if (t.pins == 1) return t.twice_seen == 1 ? 304 : 376;
    if (t.free_lines == 1) return 216;
    if (t.twice_seen == 1 && t.twice_seen_pin) return 272;
    // Two features of weight 1: points that one view or two see.
    const bool same_view = std::popcount(t.distinguished) == 1;
    if (t.twice_seen == 2) return same_view ? 0 : 384; // the same two views see five points
    if (t.twice_seen == 1) return same_view ? 464 : 368;
    return same_view ? 448 : 520;
}

/// Theorem U17: two points that all views see, and two lines that they see, too, of which one may
/// be the pin of another point.
unsigned bound_by_two_points(const Traits& t) {
    if (t.free_lines == 2 && t.pins == 1) return 264;
    if (t.free_lines == 2) return t.twice_seen == 1 ? 256 : 304;
    if (t.free_lines == 1 && t.pins == 0 && t.lines == 2) return 240;
    return 0;
}

/// Theorem Y: of problems of which all views see all, those with one point, or with two and three
/// pins or five.
unsigned bound_by_moduli(const Traits& t) {
    if (t.hidden) return 0;
    if (t.points == 1 && t.pins == 0) return 360;
    if (t.points == 1 && t.pins == 2) return 552;
    if (t.points == 1 && t.pins == 4) return 480;
    if (t.points == 2 && t.most_pins == 3) return t.free_lines == 0 ? 480 : 328;
    if (t.points == 2 && t.most_pins == 2 && t.pins == 3) return 432;
    return 0;
}

/// The bound of a minimal problem by the statements of the theorems; 0 if none speaks of it.
unsigned bound_by_statements(const Signature& signature) {
    const Traits traits = traits_of(signature);
    if (const unsigned bound = bound_by_moduli(traits)) return bound;
    if (traits.points == 3) return bound_by_three_points(traits);
    if (traits.points == 2 && traits.free_lines > 0)
        if (const unsigned bound = bound_by_two_points(traits)) return bound;
    return bound_by_lines_through_a_point(traits);
}

/// By theorem alone.
const DegreeTable& table_by_theorem() {
    static const DegreeTable table = table_of({});
    return table;
}

/// A bound is by a row of the first table.
bool in_first_table(std::size_t number) {
    const DegreeBounds& known =
        table_by_theorem().at(constraint_class(all_classes().representatives[number]));
    return std::get<TheoremRow>(known.at_most->by).row < theorem_bounds.size();
}

/// The terminal problems without five shared points, by bound, of those that have a property.
using Swaps = std::set<std::size_t>;
std::map<std::size_t, Swaps> problems_by_bound(bool (*wanted)(const Traits&)) {
    std::map<std::size_t, Swaps> problems;
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
        const Signature& signature = all_classes().representatives[n];
        const std::size_t bound = is_minimal_class(n) ? bound_by_statements(signature) : 0;
        if (bound > 0 && wanted(traits_of(signature)))
            problems[bound].insert(all_classes().swap_class[n]);
    }
    return problems;
}
} // namespace

TEST_CASE("the tables give each of the 143,494 classes the bound that the theorems state") {
    std::size_t bounded = 0, by_first_table = 0;
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
        if (!is_minimal_class(n)) continue;
        const Signature& s = all_classes().representatives[n];
        const std::size_t bound = bound_of(table_by_theorem(), n), stated = bound_by_statements(s);
        const bool first = bound > 0 && in_first_table(n);
        if (stated == 0) CHECK_FALSE(first);
        by_first_table += first;
        if (stated == 0) continue;
        CAPTURE(notation(s));
        CHECK(bound == stated);
        CHECK_FALSE(has_five_shared_points(s));
        ++bounded;
    }
    CHECK(bounded == 58);
    CHECK(by_first_table == 30);
}

TEST_CASE("the statements of the theorems do not ask for the order of the views") {
    for (std::size_t n = 0; n < all_classes().representatives.size(); n += 3)
        for (const FeatureMap& map : relabelings) {
            const Signature image = permuted(all_classes().representatives[n], map);
            CHECK(bound_by_statements(image) ==
                  bound_by_statements(all_classes().representatives[n]));
        }
}

TEST_CASE("each row is a minimal class of its own, written as its representative") {
    std::set<Signature> constraint_classes;
    for (const TheoremBound& row : theorem_bounds) {
        CAPTURE(row.problem);
        const std::size_t number = class_of(row.problem);
        CHECK(is_minimal_class(number));
        const Signature& signature = all_classes().representatives[number];
        CHECK(constraint_classes.insert(constraint_class(signature)).second);
        CHECK(bound_of(table_by_theorem(), number) == row.bound);
    }
    CHECK(constraint_classes.size() == 19);
}

TEST_CASE("the theorem of equal degrees comes first, and has one bound") {
    CHECK(theorem_bounds[0].theorem == theorem_of_equal_degrees);
    bool begins = true; // no other theorem has come
    for (const TheoremBound& row : theorem_bounds) {
        const bool equal = row.theorem == theorem_of_equal_degrees;
        CHECK((begins || !equal));
        begins = begins && equal;
        CHECK(equal == (row.bound == 64));
    }
}

TEST_CASE("terminal problems bounded by theorem") {
    const auto one_point = problems_by_bound([](const Traits& t) {
        return t.points != 3 && !(t.points == 2 && t.free_lines > 0) && bound_by_moduli(t) == 0;
    });
    CHECK(one_point.size() == 3);
    CHECK(one_point.at(64).size() == 13);                      // six lines through a point
    CHECK(one_point.at(240) == Swaps{18, 19, 20, 21, 69, 70}); // five, and another
    CHECK(one_point.at(272) == Swaps{22, 23, 32, 33, 34, 35, 36, 71, 72}); // and two points
    CHECK(problems_by_bound([](const Traits& t) { return t.points == 3; }) ==
          std::map<std::size_t, Swaps>{{216, {6722}},
                                       {224, {811}},
                                       {272, {6723}},
                                       {304, {2446}},
                                       {312, {2394}},
                                       {368, {6727, 6729}},
                                       {376, {2447, 2448}},
                                       {384, {6725}},
                                       {448, {6730, 6732, 6734}},
                                       {464, {6726, 6728}},
                                       {520, {6731, 6733, 6735}}});
    CHECK(problems_by_bound([](const Traits& t) {
              return t.points == 2 && t.free_lines > 0 && bound_by_moduli(t) == 0;
          }) == std::map<std::size_t, Swaps>{
                    {240, {6736}}, {256, {6767}}, {264, {2455}}, {304, {6768, 6769}}});
    CHECK(problems_by_bound([](const Traits& t) { return bound_by_moduli(t) > 0; }) ==
          std::map<std::size_t, Swaps>{
              {328, {249}}, {360, {8726}}, {432, {797}}, {480, {79, 245}}, {552, {990}}});
}

TEST_CASE("problems of which the theorems speak, and problems beside them") {
    const auto upper = [](std::string_view problem) {
        return bound_by_statements(all_classes().representatives[class_of(problem)]);
    };
    CHECK(upper("Pabcdef/Pabcdef/Pabcdef + 2*P/a/a") == 64);
    CHECK(upper("Pabcde/Pabcde/Pabcde + P/P/P") == 64); // the line to the other point is the sixth
    CHECK(upper("Pabcde/Pabcde/Pabcde + a/P/Pa + -/P/P") == 272);
    CHECK(upper("Pabcde/Pabcde/Pabcde + a/P/Pa + P/-/P") == 272);
    CHECK(upper("Pabcde/Pabcde/Pabcde + a/P/Pa + P/a/a") == 0);
    CHECK(upper("Pabcde/Pabcde/Pabcde + -/P/P + P/-/P + P/P/-") == 0);
    CHECK(upper("Pabcd/Pabcd/Pabcd + Pa/Pa/Pa") == 240); // the line to the other point
    CHECK(upper("Pabcd/Pabcd/Pabcd + P/P/P + -/P/P") == 240);
    CHECK(upper("Pabcd/Pabcd/Pabcd + P/P/P + P/a/a") == 272);
    CHECK(upper("Pabc/Pabc/Pabc + P/P/P + a/a/a") == 328);
    CHECK(upper("Pab/Pab/Pab + Pa/Pa/Pa + a/a/a") == 432); // as many pins, on two points
    CHECK(upper("Pabc/Pabc/Pabc + P/P/P + 2*-/P/P") == 0); // four lines through a point
    CHECK(upper("2*Pa/Pa/Pa + P/P/P") == 312);             // the Chicago problem
    CHECK(upper("Pa/Pa/Pa + P/P/P + 2*a/a/a") == 264);     // two points, and two lines
    CHECK(upper("2*P/P/P + 2*a/a/a + -/P/P") == 256);
    CHECK(upper("2*P/P/P + a/Pa/Pa + a/a/a") == 240);
    CHECK(upper("2*P/P/P + a/a/a + a/P/Pa + -/P/P") == 0); // the pin is not seen by all
    CHECK(upper("Pa/Pa/Pa + P/P/P + a/Pa/Pa + -/P/P") == 0);
    CHECK(upper("Pa/Pa/Pa + P/P/P + a/a/a + 2*-/P/P") == 0);
    CHECK(upper("2*P/P/P + a/a/a + 2*-/P/P + P/-/P") == 0);
}
