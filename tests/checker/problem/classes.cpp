// Features, signatures and their classes, against the paper's tables, laws and brute force.
#include "tests/support/all_classes.h"

#include <numeric>
#include <set>

using namespace checker;

namespace {

/// All signatures into which swaps of single features turn this one.
std::set<Signature> swapped(const Signature& signature) {
    const FeatureMap swap = swap_of_features();
    std::set<Signature> found{signature};
    for (std::size_t i = 0; i < feature_count; ++i) {
        if (swap[i] <= i) continue;
        std::set<Signature> more;
        for (Signature split : found) {
            const unsigned both = split[i] + split[swap[i]];
            for (split[i] = 0; split[i] <= both; ++split[i]) {
                split[swap[i]] = both - split[i];
                more.insert(split);
            }
        }
        found = more;
    }
    return found;
}

} // namespace

TEST_CASE("the known numbers of signatures and classes") {
    CHECK(all_classes().signatures == 845161);
    CHECK(all_classes().representatives.size() == 143494);
    const std::set<std::size_t> swap_classes(all_classes().swap_class.begin(),
                                             all_classes().swap_class.end());
    CHECK(swap_classes.size() == 76446);
    for (std::size_t n = 0; n < all_classes().swap_class.size(); ++n) {
        const std::size_t first = all_classes().swap_class[n];
        REQUIRE(first <= n);
        REQUIRE(all_classes().swap_class[first] == first);
        REQUIRE(all_classes().represents_swap_class(n) == (first == n));
        REQUIRE(number_of(all_classes(), all_classes().representatives[n]) == n);
    }
    CHECK(notation(all_classes().representatives[2394]) == "2*Pa/Pa/Pa + P/P/P");
    CHECK(notation(all_classes().representatives[6722]) == "3*P/P/P + a/a/a");
}

TEST_CASE(
    "representatives decrease, are balanced, and their orbits make up all balanced signatures") {
    std::size_t signatures = 0;
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
        const Signature& s = all_classes().representatives[n];
        if (n > 0) REQUIRE(s < all_classes().representatives[n - 1]);
        unsigned weight = 0;
        for (std::size_t i = 0; i < feature_count; ++i)
            weight += s[i] * features[i].weight();
        REQUIRE(weight == 11);
        std::set<Signature> orbit;
        for (const FeatureMap& map : relabelings) {
            orbit.insert(permuted(s, map));
            REQUIRE(represents_label_class(permuted(s, map)) == (permuted(s, map) == s));
        }
        REQUIRE(6 % orbit.size() == 0);
        REQUIRE(*orbit.rbegin() == s);
        signatures += orbit.size();
    }
    CHECK(signatures == all_classes().signatures);
}

TEST_CASE("the largest signature of a swap&label class is found among all of them") {
    for (std::size_t n = 0; n < all_classes().representatives.size(); n += 499) {
        const Signature& s = all_classes().representatives[n];
        Signature largest{};
        for (const FeatureMap& map : relabelings)
            largest = std::max(largest, *swapped(permuted(s, map)).rbegin());
        CHECK(largest_swapped(s) == largest);
        CHECK(all_classes().representatives[all_classes().swap_class[n]] == largest);
    }
}

TEST_CASE("weights, relabelings and swaps are those of the paper's table") {
    const std::array<unsigned, feature_count> weights{10, 9, 8, 7, 6, 5, 4, 3, 3, 3, 3, 2, 2, 2,
                                                      2,  2, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    for (std::size_t i = 0; i < feature_count; ++i)
        CHECK(features[i].weight() == weights[i]);

    FeatureMap expected{};
    std::iota(expected.begin(), expected.end(), 0U);
    for (const std::size_t i : {12U, 14U, 16U})
        std::swap(expected[i], expected[i + 1]);
    const FeatureMap swap = swap_of_features();
    CHECK(swap == expected);
    for (std::size_t i = 0; i < feature_count; ++i)
        CHECK(earlier_of_swap[i] == std::min(i, swap[i]));

    const FeatureMap rotation{0,  1,  2,  3,  4,  5,  6,  7,  10, 8,  9,  11, 16, 17,
                              13, 12, 15, 14, 20, 18, 19, 23, 21, 22, 26, 24, 25};
    const FeatureMap reflection{0,  1,  2,  3,  4,  5,  6,  7,  8,  10, 9,  11, 13, 12,
                                16, 17, 14, 15, 18, 20, 19, 21, 23, 22, 24, 26, 25};
    CHECK(std::count(relabelings.begin(), relabelings.end(), rotation) == 1);
    CHECK(std::count(relabelings.begin(), relabelings.end(), reflection) == 1);
    CHECK(std::set<FeatureMap>(relabelings.begin(), relabelings.end()).size() == 6);
    for (const FeatureMap& map : relabelings) // swaps commute with relabelings
        for (std::size_t i = 0; i < feature_count; ++i)
            CHECK(map[swap[i]] == swap[map[i]]);
}

TEST_CASE("a feature is found by its notation, and by what the views see of it") {
    for (std::size_t i = 0; i < feature_count; ++i) {
        CHECK(index_of(features[i].notation) == i);
        CHECK(index_of(features[i]) == i);
    }
    CHECK(index_of("Pb/P/P") == feature_count);
    CHECK(index_of("Pab/a/b") == feature_count); // it is Pab/b/a with other names
    CHECK(index_of(observe("Pab/a/b")) == index_of("Pab/b/a"));
    CHECK(index_of(Feature{.point = 0b001, .pin = {0b011, 0b101}, .pins = 2}) ==
          index_of("Pab/b/a"));
    CHECK(index_of(observe("PXq/q/X")) == index_of("Pab/b/a"));
    CHECK(index_of(observe("Pa/a/a")) == feature_count);
    CHECK(index_of(observe("a/a/a(P)")) == feature_count); // not the free line
}
