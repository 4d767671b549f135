// The cycles of Frobenius elements, and the groups that they show (proofs/fibres.md, section 6).
#include "checker/fibres/frobenius.h"

#include <doctest/doctest.h>
#include <numeric>

using namespace checker;

namespace {

/// The cycles of k -> q k on the numbers modulo m.
CycleType cycles_of_multiples(std::size_t m) {
    const auto image = [&](std::size_t k) { return modulus % m * k % m; };
    CycleType lengths;
    for (std::size_t first = 0; first < m; ++first) {
        std::size_t length = 1, least = first;
        for (std::size_t k = image(first); k != first; k = image(k), ++length)
            least = std::min(least, k);
        if (least == first) lengths.push_back(length);
    }
    std::ranges::sort(lengths);
    return lengths;
}

} // namespace

TEST_CASE("roots of unity are permuted as their exponents are multiplied by q") {
    for (std::size_t m = 1; m <= 48; ++m) {
        CAPTURE(m);
        Polynomial lower(m); // t^m - 1
        lower[0] = -Residue{1};
        CHECK(cycle_type_of(lower) == cycles_of_multiples(m));
        const CycleType cycles = cycle_type_of(lower);
        CHECK(frobenius_is_even(lower) == ((m - cycles.size()) % 2 == 0));
    }
    // (t - 1) ... (t - 8): all roots are fixed.
    Polynomial product{{1}};
    for (std::uint64_t root = 1; root <= 8; ++root) {
        Polynomial next(product.size() + 1);
        for (std::size_t i = 0; i < product.size(); ++i) {
            next[i + 1] = next[i + 1] + product[i];
            next[i] = next[i] - Residue{root} * product[i];
        }
        product = next;
    }
    product.pop_back();
    CHECK(cycle_type_of(product) == CycleType(8, 1));
}

TEST_CASE("cycles of fibres show a group if no set is kept, and one is a long prime") {
    const CycleType whole{8}, five{3, 5}, odd_five{1, 2, 5}, seven{1, 7};
    CHECK(group_shown_by({}, 8).empty());
    CHECK(group_shown_by({}, 0).empty());
    CHECK(group_shown_by({whole, five}, 8) == "S8");
    CHECK(group_shown_by({five, whole, whole}, 8) == "S8");
    CHECK(group_shown_by({whole, odd_five}, 8) == ">=A8");
    // Once more the same: a set of three may be kept.
    CHECK(group_shown_by({five}, 8).empty());
    CHECK(group_shown_by({five, five}, 8).empty());
    CHECK(group_shown_by({five, odd_five}, 8).empty());
    CHECK(group_shown_by({five, seven}, 8) == ">=A8");
    CHECK(group_shown_by({five, odd_five, seven}, 8) == "S8");
    // A cycle of 7 of 8 says nothing; nor does one of half of the points, or of no prime length.
    CHECK(group_shown_by({whole, seven}, 8).empty());
    CHECK(group_shown_by({{9}, {2, 7}}, 9).empty());
    CHECK(group_shown_by({{10}, {5, 5}}, 10).empty());
    CHECK(group_shown_by({{16}, {1, 15}, {7, 9}}, 16).empty());
    CHECK(group_shown_by({{16}, {3, 13}}, 16) == "S16");
    CHECK(group_shown_by({{16}, {2, 14}, {3, 13}}, 16) == "S16");
    // Permutations of fewer or more points are none of these.
    CHECK(group_shown_by({{7}, {3, 5}}, 8).empty());
    CHECK(group_shown_by({{9}, {3, 5}, {1, 8}}, 8).empty());
    CHECK(group_shown_by({{7}, {2, 5}}, 7).empty());
}
