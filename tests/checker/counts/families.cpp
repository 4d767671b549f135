// Families of problems: laws over all classes, and second methods.
#include "checker/counts/families.h"
#include "checker/problem/notation.h"
#include "tests/support/all_classes.h"

#include <set>

using namespace checker;

namespace {

/// The feature as a terminal problem has it: a pin that just two views see is dropped in the view
/// that sees its point.
Feature terminal(Feature feature) {
    for (unsigned pin = 0; pin < feature.pins; ++pin) {
        const Views seen = feature.pin[pin];
        if (std::popcount(seen) == 2 && !feature.free_line)
            feature.pin[pin] = seen & ~feature.point;
    }
    return feature;
}

/// The weight of the terminal problem, by the notation of its features.
int terminal_weight(const Signature& signature) {
    static const std::array<int, feature_count> weights = [] {
        std::array<int, feature_count> result{};
        for (std::size_t i = 0; i < feature_count; ++i) {
            const std::string notation = spell(terminal(features[i]), 3);
            const Feature observed = observe(notation);
            result[i] =
                static_cast<int>(observed.equations) - static_cast<int>(observed.unknowns());
        }
        return result;
    }();
    int sum = 0;
    for (std::size_t i = 0; i < feature_count; ++i)
        sum += static_cast<int>(signature[i]) * weights[i];
    return sum;
}

/// Kileel's list, as his paper has it: numbers of PPP, PPL, PLP, LLL and PLL correspondences of
/// total weight 11, where views 2 and 3 may be exchanged. Lifted, by swap&label class.
std::set<std::size_t> kileels_list() {
    std::set<std::size_t> found;
    std::size_t quintuples = 0;
    for (unsigned ppp = 0; ppp <= 3; ++ppp)
        for (unsigned ppl = 0; ppl <= 5; ++ppl)
            for (unsigned plp = 0; plp <= ppl; ++plp)
                for (unsigned lll = 0; lll <= 5; ++lll) {
                    const unsigned weight = 3 * ppp + 2 * (ppl + plp + lll);
                    if (weight > 11) continue;
                    ++quintuples;
                    const Signature lifted = signature_of({{"P/P/P", ppp},
                                                           {"Pa/P/a", ppl},
                                                           {"Pa/a/P", plp},
                                                           {"a/a/a", lll},
                                                           {"P/a/a", 11 - weight}});
                    found.insert(number_of(all_classes(), largest_swapped(lifted)));
                }
    CHECK(quintuples == 66);
    return found;
}

/// The number of points that two views share, by their letters.
unsigned shared(const Signature& signature, std::size_t first, std::size_t second) {
    unsigned points = 0;
    for (std::size_t i = 0; i < feature_count; ++i) {
        std::array<std::string, 3> views;
        std::size_t view = 0;
        for (const char c : features[i].notation)
            if (c == '/')
                ++view;
            else
                views[view] += c;
        const bool both = views[first].starts_with('P') && views[second].starts_with('P');
        if (both) points += signature[i];
    }
    return points;
}

} // namespace

TEST_CASE("families do not depend on the order of the views") {
    for (const Signature& s : all_classes().representatives)
        for (const FeatureMap& map : relabelings) {
            const Signature other = permuted(s, map);
            REQUIRE(is_pl0p(other) == is_pl0p(s));
            REQUIRE(at_most_one_pin(other) == at_most_one_pin(s));
            REQUIRE(completely_visible(other) == completely_visible(s));
            REQUIRE(linear_in_trifocal_tensor(other) == linear_in_trifocal_tensor(s));
            REQUIRE(terminal_has_dangling_pins(other) == terminal_has_dangling_pins(s));
            REQUIRE(extends_five_points(other) == extends_five_points(s));
            REQUIRE(is_registration(other) == is_registration(s));
        }
}

TEST_CASE("families that are defined by terminal problems do not depend on swaps") {
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
        const Signature& s = all_classes().representatives[n];
        const Signature& first = all_classes().representatives[all_classes().swap_class[n]];
        REQUIRE(is_pl0p(first) == is_pl0p(s));
        REQUIRE(at_most_one_pin(first) == at_most_one_pin(s));
        REQUIRE(completely_visible(first) == completely_visible(s));
        REQUIRE(linear_in_trifocal_tensor(first) == linear_in_trifocal_tensor(s));
        REQUIRE(terminal_has_dangling_pins(first) == terminal_has_dangling_pins(s));
    }
}

TEST_CASE("a family is in another where it must be") {
    for (const Signature& s : all_classes().representatives) {
        if (is_pl0p(s)) REQUIRE(at_most_one_pin(s));
        if (is_registration(s)) REQUIRE(extends_five_points(s));
        if (completely_visible(s)) REQUIRE(!terminal_has_dangling_pins(s));
        if (is_pl0p(s)) REQUIRE(!terminal_has_dangling_pins(s));
        if (linear_in_trifocal_tensor(s)) REQUIRE(at_most_one_pin(s));
    }
}

TEST_CASE("Kileel's list: its 66 quintuples are the terminal problems linear in the tensor") {
    std::set<std::size_t> found;
    std::size_t minimal_as_they_stand = 0;
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
        const Signature& s = all_classes().representatives[n];
        if (!all_classes().represents_swap_class(n) || !obstruction(s).minimal()) continue;
        if (!linear_in_trifocal_tensor(s)) continue;
        found.insert(n);
        minimal_as_they_stand += !terminal_has_dangling_pins(s);
    }
    CHECK(found == kileels_list());
    CHECK(found.size() == 66);
    CHECK(minimal_as_they_stand == 16);
    // 3 PPP and 1 PPL is on the list; a pin that all views see is not, nor is a line in the view
    // that the tensor distinguishes.
    CHECK(linear_in_trifocal_tensor(signature_of({{"P/P/P", 3}, {"a/P/Pa", 1}})));
    CHECK_FALSE(linear_in_trifocal_tensor(signature_of({{"P/P/P", 1}, {"Pa/Pa/Pa", 2}})));
    CHECK_FALSE(
        linear_in_trifocal_tensor(signature_of({{"P/P/P", 3}, {"P/a/a", 1}, {"a/P/a", 1}})));
}

TEST_CASE("the terminal notation weighs 11 if and only if no pin dangles") {
    std::size_t problems = 0, balanced = 0;
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
        const Signature& s = all_classes().representatives[n];
        if (!all_classes().represents_swap_class(n) || !obstruction(s).minimal()) continue;
        ++problems;
        REQUIRE((terminal_weight(s) == 11) == !terminal_has_dangling_pins(s));
        REQUIRE(terminal_weight(s) <= 11);
        balanced += terminal_weight(s) == 11;
    }
    CHECK(problems == 74575);
    CHECK(balanced == 3839);
    CHECK(spell(terminal(features[index_of("Pa/P/a")]), 3) == "P/P/a");
    CHECK(spell(terminal(features[index_of("Pab/b/a")]), 3) == "P/b/a");
    CHECK(spell(terminal(features[index_of("P/a/a")]), 3) == "P/a/a");
}

TEST_CASE("two views share the points whose letter both have") {
    for (std::size_t n = 0; n < all_classes().representatives.size(); n += 13) {
        const Signature& s = all_classes().representatives[n];
        const bool five = shared(s, 0, 1) == 5 || shared(s, 0, 2) == 5 || shared(s, 1, 2) == 5;
        REQUIRE(extends_five_points(s) == five);
    }
}

TEST_CASE("a registration leaves one camera, whatever else there is to see") {
    CHECK(is_registration(signature_of({{"P/P/P", 3}, {"-/P/P", 2}})));
    CHECK(is_registration(signature_of({{"a/a/a", 3}, {"-/P/P", 5}})));
    CHECK_FALSE(is_registration(signature_of({{"P/P/P", 2}, {"-/P/P", 3}, {"P/-/P", 2}})));
    CHECK_FALSE(is_registration(signature_of({{"P/P/P", 3}, {"-/P/P", 1}, {"P/-/P", 1}})));
}
