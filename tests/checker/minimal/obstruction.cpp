// Obstructions: known counts, laws over all classes, and stars one by one.
#include "tests/support/all_classes.h"

using namespace checker;

TEST_CASE("obstructions: known counts, and the same for all of an orbit and under swaps") {
    const FeatureMap swap = swap_of_features();
    std::size_t obstructed = 0, by_excess = 0;
    for (const Signature& s : all_classes().representatives) {
        const Obstruction found = obstruction(s);
        obstructed += !found.minimal();
        by_excess += found.epipolar() > 0;
        for (const FeatureMap& map : relabelings) {
            const Obstruction other = obstruction(permuted(s, map));
            REQUIRE(other.epipolar() == found.epipolar());
            REQUIRE(other.star == found.star);
        }
        REQUIRE(obstruction(permuted(s, swap)).deficiency() == found.deficiency());
    }
    CHECK(obstructed == 2878);
    CHECK(by_excess == 2871);
}

TEST_CASE("a class and its swap&label class are both minimal or both not") {
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
        const std::size_t first = all_classes().swap_class[n];
        const Obstruction one = obstruction(all_classes().representatives[n]);
        const Obstruction other = obstruction(all_classes().representatives[first]);
        REQUIRE(one.minimal() == other.minimal());
        REQUIRE(one.deficiency() == other.deficiency());
    }
}

TEST_CASE("the excess of a pair of views is what they share beyond five points") {
    for (std::size_t n = 0; n < all_classes().representatives.size(); n += 37) {
        const Signature& s = all_classes().representatives[n];
        const Obstruction found = obstruction(s);
        for (std::size_t pair = 0; pair < 3; ++pair) {
            const std::size_t first = pair == 2 ? 1 : 0, second = pair == 0 ? 1 : 2;
            unsigned shared = 0;
            for (std::size_t i = 0; i < feature_count; ++i) {
                const bool both =
                    has_view(features[i].point, first) && has_view(features[i].point, second);
                if (both) shared += s[i];
            }
            REQUIRE(found.excess[pair] == (shared < 5 ? 0 : shared - 5));
        }
        REQUIRE(found.minimal() == (found.epipolar() == 0 && found.star == 0));
    }
}

TEST_CASE("what a star obstructs") {
    const std::string_view six_pins = "Pabcdef/Pabcdef/Pabcdef";
    const std::string_view five_pins = "Pabcde/Pabcde/Pabcde";
    CHECK(obstruction(signature_of({{six_pins, 1}, {"a/a/a", 1}})).star == 1);
    CHECK(obstruction(signature_of({{six_pins, 1}, {"a/P/Pa", 1}})).star == 0);
    // View 1 sees nothing but the star.
    CHECK(obstruction(signature_of({{five_pins, 1}, {"-/P/P", 3}})).star == 1);
    CHECK(obstruction(signature_of({{five_pins, 1}, {"-/P/P", 2}, {"P/-/P", 1}})).star == 0);
}
