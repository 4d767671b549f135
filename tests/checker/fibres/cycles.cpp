// The cycles of Frobenius elements, and the groups that they show (proofs/fibres.md, Theorem 2).
#include "checker/fibres/frobenius.h"

#include <doctest/doctest.h>
#include <numeric>
#include <set>

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

using Permutation = std::vector<std::size_t>;

/// The permutations that these generate.
std::set<Permutation> group_of(const std::vector<Permutation>& generators) {
    Permutation identity(generators.front().size());
    std::iota(identity.begin(), identity.end(), 0);
    std::set<Permutation> group{identity};
    std::vector<Permutation> left{identity};
    while (!left.empty()) {
        const Permutation permutation = left.back();
        left.pop_back();
        for (const Permutation& generator : generators) {
            Permutation product;
            for (const std::size_t point : permutation)
                product.push_back(generator[point]);
            if (group.insert(product).second) left.push_back(product);
        }
    }
    return group;
}

CycleType cycles_of(const Permutation& permutation) {
    CycleType lengths;
    std::vector<bool> seen(permutation.size());
    for (std::size_t first = 0; first < seen.size(); ++first) {
        std::size_t length = 0;
        for (std::size_t point = first; !seen[point]; point = permutation[point], ++length)
            seen[point] = true;
        if (length > 0) lengths.push_back(length);
    }
    std::ranges::sort(lengths);
    return lengths;
}

/// What the cycles of all permutations of a group show of it.
std::string shown(const std::vector<Permutation>& generators, Orbits orbits) {
    std::set<CycleType> all;
    for (const Permutation& permutation : group_of(generators))
        all.insert(cycles_of(permutation));
    return group_shown_by({all.begin(), all.end()}, generators.front().size(), orbits);
}

} // namespace

TEST_CASE("roots of unity are permuted as their exponents are multiplied by q") {
    for (std::size_t m = 1; m <= 48; ++m) {
        CAPTURE(m);
        Polynomial lower(m); // t^m - 1
        lower[0] = -Residue{1};
        CHECK(cycle_type_of(lower) == cycles_of_multiples(m));
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

TEST_CASE("cycles of fibres show a group if no set and no blocks are kept, and a prime is alone") {
    const CycleType whole{8}, five{3, 5}, odd_five{1, 2, 5}, seven{1, 7};
    const auto shown_by = [](const std::vector<CycleType>& types, std::size_t solutions) {
        return group_shown_by(types, solutions, Orbits::unknown);
    };
    CHECK(shown_by({}, 8).empty());
    CHECK(shown_by({}, 0).empty());
    CHECK(shown_by({whole, five}, 8) == "S8");
    CHECK(shown_by({five, whole, whole}, 8) == "S8");
    CHECK(shown_by({whole, odd_five}, 8) == ">=A8");
    // Once more the same: a set of three may be kept.
    CHECK(shown_by({five}, 8).empty());
    CHECK(shown_by({five, five}, 8).empty());
    CHECK(shown_by({five, odd_five}, 8).empty());
    CHECK(shown_by({five, seven}, 8) == ">=A8");
    CHECK(shown_by({five, odd_five, seven}, 8) == "S8");
    // A cycle of 7 of 8 says nothing; nor does one that is not alone, or of no prime length.
    CHECK(shown_by({whole, seven}, 8).empty());
    CHECK(shown_by({{10}, {5, 5}, {1, 3, 6}}, 10).empty());
    CHECK(shown_by({{16}, {1, 15}, {7, 9}}, 16) == "S16"); // as 7 is
    CHECK(shown_by({{16}, {1, 15}, {8, 8}}, 16).empty());
    CHECK(shown_by({{16}, {3, 13}}, 16) == "S16");
    // Permutations of fewer or more points are none of these.
    CHECK(shown_by({{7}, {3, 5}}, 8).empty());
    CHECK(shown_by({{9}, {3, 5}, {1, 8}}, 8).empty());
    // Where one orbit is known, two permutations are needed nevertheless.
    CHECK(group_shown_by({five, odd_five}, 8, Orbits::one) == "S8");
    CHECK(group_shown_by({five}, 8, Orbits::one).empty());
    CHECK(group_shown_by({{2}, {1, 1}}, 2, Orbits::one) == "S2");
    CHECK(group_shown_by({{1, 1}, {1, 1}}, 2, Orbits::one).empty());
    CHECK(group_shown_by({{3}, {1, 2}}, 3, Orbits::one) == "S3");
    CHECK(group_shown_by({{1, 3}, {4}}, 4, Orbits::one) == "S4");
    CHECK(group_shown_by({{1, 3}, {1, 1, 2}}, 4, Orbits::one) == "S4");
    CHECK(group_shown_by({{1, 1, 2}, {4}}, 4, Orbits::one).empty()); // may keep two pairs
    CHECK(group_shown_by({{1}}, 1, Orbits::one).empty());
}

TEST_CASE("a group that does not contain all even permutations is never shown to") {
    const Permutation five{1, 2, 3, 4, 0}, six{1, 2, 3, 4, 5, 0}, seven{1, 2, 3, 4, 5, 6, 0};
    const std::vector<std::vector<Permutation>> smaller{
        {{1, 0, 3, 2}, {2, 3, 0, 1}},                  // four permutations of four points
        {{1, 2, 3, 0}, {0, 3, 2, 1}},                  // of a square
        {five, {0, 4, 3, 2, 1}},                       // of a pentagon
        {five, {0, 2, 4, 1, 3}},                       // k -> a k + b modulo 5
        {six, {1, 0, 2, 3, 4, 5}, {3, 1, 2, 0, 4, 5}}, // all, so left out below
        {{1, 2, 0, 3, 4, 5}, {3, 4, 5, 0, 1, 2}},      // two blocks of three
        {{1, 0, 2, 3, 4, 5}, {2, 3, 4, 5, 0, 1}},      // three blocks of two
        {{1, 2, 3, 4, 0, 5}, {5, 4, 2, 3, 1, 0}},      // k -> k + 1, -1/k modulo 5, and infinity
        {{1, 2, 3, 4, 0, 5}, {0, 2, 4, 1, 3, 5}, {5, 4, 2, 3, 1, 0}}, // and k -> 2 k
        {seven, {0, 3, 6, 2, 5, 1, 4}},                               // k -> a k + b modulo 7
        {seven, {0, 2, 1, 4, 3, 5, 6}, {0, 1, 2, 3, 4, 5, 6}}};
    for (const std::vector<Permutation>& generators : smaller) {
        const std::size_t points = generators.front().size();
        std::size_t all = 1;
        for (std::size_t n = 2; n <= points; ++n)
            all *= n;
        const std::size_t size = group_of(generators).size();
        CAPTURE(points);
        CAPTURE(size);
        for (const Orbits orbits : {Orbits::one, Orbits::unknown}) {
            const bool contains = !shown(generators, orbits).empty();
            CHECK(contains == (2 * size >= all));
        }
    }
    for (std::size_t points = 2; points <= 7; ++points) { // all permutations
        Permutation cycle(points), swap(points);
        std::iota(swap.begin(), swap.end(), 0);
        std::swap(swap[0], swap[1]);
        for (std::size_t point = 0; point < points; ++point)
            cycle[point] = (point + 1) % points;
        CHECK(shown({cycle, swap}, Orbits::unknown) == "S" + std::to_string(points));
    }
}

TEST_CASE("cycles are looked for where two fibres have most solutions") {
    std::uint64_t effort = 0;
    const auto spend = [&](std::uint64_t more) { effort += more; };
    const Polynomial two{{1}, {0}}, three{{1}, {1}, {0}}; // t^2 + 1 and t^3 + t + 1
    CHECK(cycle_types_of({}, spend).empty());
    CHECK(cycle_types_of({two, three, two}, spend).empty());
    CHECK(cycle_types_of({two, three, three}, spend).size() == 2);
    CHECK(effort == 0); // for so few solutions
    const Polynomial many(100, Residue{1});
    CHECK(cycle_types_of({many, many}, spend).size() == 2);
    CHECK(effort == 2 * 80);
}
