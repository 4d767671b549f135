// Permutation groups whose orders and blocks are known.
#include "prover/groups/blocks.h"
#include "prover/groups/jordan.h"
#include "prover/groups/monodromy_group.h"
#include "prover/groups/stabilizer_chain.h"

#include <doctest/doctest.h>
#include <numeric>

using namespace plprove;

namespace {

using Cycles = std::vector<std::vector<int>>;

Permutation permutation(int degree, const Cycles& cycles) {
    Permutation result = identity(degree);
    for (const std::vector<int>& cycle : cycles)
        for (std::size_t i = 0; i < cycle.size(); ++i)
            result[as_index(cycle[i])] = cycle[(i + 1) % cycle.size()];
    return result;
}

std::vector<int> range(int first, int count) {
    std::vector<int> result(as_index(count));
    std::iota(result.begin(), result.end(), first);
    return result;
}

/// All permutations, or all even ones, of the first `count` of `degree` points.
std::vector<Permutation> symmetric(int count, int degree) {
    return {permutation(degree, {range(0, count)}), permutation(degree, {{0, 1}})};
}
std::vector<Permutation> alternating(int count, int degree) {
    const int odd = count % 2 == 1 ? count : count - 1;
    return {permutation(degree, {range(count - odd, odd)}), permutation(degree, {{0, 1, 2}})};
}

/// Moves whole blocks of points as these permutations move their numbers.
std::vector<Permutation> moving_blocks(const std::vector<Permutation>& permutations, int size) {
    std::vector<Permutation> result;
    for (const Permutation& one : permutations) {
        Permutation& moved = result.emplace_back();
        for (const int block : one)
            for (int i = 0; i < size; ++i)
                moved.push_back(block * size + i);
    }
    return result;
}

/// One group within the first block, another on the blocks.
std::vector<Permutation> wreath(std::vector<Permutation> within,
                                const std::vector<Permutation>& on_top, int size) {
    for (Permutation& moved : moving_blocks(on_top, size))
        within.push_back(std::move(moved));
    return within;
}

int order(const std::vector<Permutation>& generators) {
    int product = 1;
    for (const int length : StabilizerChain(generators).orbit_lengths())
        product *= length;
    return product;
}

/// The Mathieu groups of degree 11 and 12.
std::vector<Permutation> mathieu(int degree) {
    std::vector<Permutation> result = {
        permutation(degree, {range(0, 11)}),
        permutation(degree, {{2, 6, 10, 7}, {3, 9, 4, 5}}),
    };
    if (degree == 12)
        result.push_back(permutation(degree, {{0, 11}, {1, 10}, {2, 5}, {3, 7}, {4, 8}, {6, 9}}));
    return result;
}

} // namespace

TEST_CASE("permutations are multiplied, inverted, and counted by cycles") {
    const Permutation one = permutation(6, {{0, 1, 2}}), other = permutation(6, {{2, 3}});
    CHECK(then(one, other) == permutation(6, {{0, 1, 3, 2}}));
    CHECK(then(one, inverse(one)) == identity(6));
    CHECK(is_identity(identity(6)));
    CHECK_FALSE(is_identity(one));
    CHECK(cycle_type(then(one, other)) == std::vector<int>{1, 1, 4});
    CHECK(is_even(one));
    CHECK_FALSE(is_even(other));
}

TEST_CASE("orders of groups are those of the literature") {
    CHECK(order(symmetric(10, 10)) == 3'628'800);
    CHECK(order(alternating(10, 10)) == 1'814'400);
    CHECK(order(mathieu(11)) == 7920);
    CHECK(order(mathieu(12)) == 95'040);
    CHECK(order({permutation(9, {range(0, 9)})}) == 9);
    CHECK(order({permutation(8, {range(0, 8)}), permutation(8, {{1, 7}, {2, 6}, {3, 5}})}) == 16);
    CHECK(order({identity(5)}) == 1);
    CHECK(order(wreath(symmetric(3, 12), symmetric(4, 4), 3)) == 6 * 6 * 6 * 6 * 24);
}

TEST_CASE("blocks of least size are found") {
    CHECK(is_transitive(symmetric(9, 9)));
    CHECK_FALSE(is_transitive(symmetric(8, 9)));
    CHECK_FALSE(is_transitive({}));
    CHECK(least_blocks(symmetric(9, 9)).blocks == 1);
    CHECK(least_blocks(mathieu(12)).blocks == 1);
    const std::vector<Permutation> twelve = {permutation(12, {range(0, 12)})};
    CHECK(least_blocks(twelve).blocks == 6);
    CHECK(blocks_joining(twelve, 0, 4).blocks == 4);
    CHECK(blocks_joining(twelve, 0, 3).block_of ==
          std::vector<int>{0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2});
    const BlockSystem blocks = least_blocks(wreath(symmetric(3, 12), symmetric(4, 4), 3));
    CHECK(blocks.block_of == std::vector<int>{0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3});
    CHECK(on_blocks(moving_blocks(symmetric(4, 4), 3), blocks) == symmetric(4, 4));
}

TEST_CASE("Jordan's theorem wants a prime between half the degree and the degree less two") {
    CHECK(shows_alternating(312, 271));
    CHECK_FALSE(shows_alternating(312, 156));
    CHECK_FALSE(shows_alternating(312, 270));
    CHECK_FALSE(shows_alternating(12, 11)); // M12 has such a cycle
    CHECK(shows_alternating(14, 11));
    CHECK_FALSE(shows_alternating(14, 7));
}

TEST_CASE("a primitive group is one step") {
    const MonodromyGroup all = monodromy_group(symmetric(30, 30));
    CHECK(all.name() == "S30");
    CHECK(all.order() == "30!");
    CHECK(all.width() == 30);
    CHECK(all.is_symmetric());
    const MonodromyGroup even = monodromy_group(alternating(30, 30));
    CHECK(even.name() == "A30");
    CHECK(even.order() == "30!/2");
    CHECK_FALSE(even.is_symmetric());
    const MonodromyGroup other = monodromy_group(mathieu(12));
    CHECK(other.name() == "<G12");
    CHECK(other.order() == "12!/(2^4*3^2*5*7)");
    CHECK(other.width() == 12);
    CHECK(monodromy_group(symmetric(4, 4)).width() == 3);
    CHECK(monodromy_group({permutation(2, {{0, 1}})}).name() == "S2");
    CHECK(monodromy_group({identity(1)}).name() == "S1");
    CHECK(monodromy_group({identity(1)}).order() == "1!");
}

TEST_CASE("a group with blocks is a step for the blocks and one within") {
    const MonodromyGroup group = monodromy_group(wreath(symmetric(8, 80), symmetric(10, 10), 8));
    CHECK(group.name() == "S8 wr S10");
    CHECK(group.order() == "8!^10*10!");
    CHECK(group.width() == 10);
    CHECK(group.degree() == 80);
    REQUIRE(group.steps.size() == 2);
    CHECK(group.steps[0].solutions == 10);
    CHECK(group.steps[1].solutions == 8);
    CHECK(group.steps[1].copies == 10);
    const MonodromyGroup even = monodromy_group(wreath(alternating(9, 45), alternating(5, 5), 9));
    CHECK(even.name() == "A9 wr A5");
    CHECK(even.order() == "9!^5*5!/2^6");
}

TEST_CASE("the essential matrices of five points and their twisted pairs: an index of two") {
    // Of S2 wr S10, the permutations that are even on all 20 points.
    std::vector<Permutation> generators = {permutation(20, {{0, 1}, {2, 3}})};
    for (Permutation& moved : moving_blocks(symmetric(10, 10), 2))
        generators.push_back(std::move(moved));
    const MonodromyGroup group = monodromy_group(generators);
    CHECK(group.name() == "<S2 wr S10");
    CHECK(group.order() == "2!^10*10!/2");
    CHECK(group.width() == 10);
}

TEST_CASE("a step that those before solve makes the problem no harder") {
    // All permutations of 7 points, each of which has two signs that odd permutations change.
    std::vector<Permutation> signs;
    for (const Permutation& one : symmetric(7, 7)) {
        Permutation& moved = signs.emplace_back();
        for (const int image : one)
            for (const int sign : {0, 1})
                moved.push_back(2 * image + (is_even(one) ? sign : 1 - sign));
    }
    const MonodromyGroup group = monodromy_group(signs);
    REQUIRE(group.steps.size() == 2);
    CHECK(group.steps[0].solutions == 7);
    CHECK(group.steps[1].solutions == 2);
    CHECK(group.order() == "2!^7*7!/2^7");
    CHECK(group.name() == "<S2 wr S7");
    CHECK(group.width() == 7);
}

TEST_CASE("edges show that a group is symmetric only if they do whichever is left out") {
    constexpr int degree = 30;
    RandomElements elements(symmetric(degree, degree));
    std::vector<Permutation> even, odd;
    while (even.size() < 3 || odd.size() < 2) {
        const Permutation next = elements.next();
        (is_even(next) ? even : odd).push_back(next);
    }
    const std::vector<Permutation> edges = {even[0], odd[0], even[1], odd[1]};
    const auto group = symmetric_group_of_edges(edges);
    REQUIRE(group);
    CHECK(group->name() == "S30");
    CHECK(*group == monodromy_group(loops_of_edges(edges)));
    CHECK_FALSE(symmetric_group_of_edges({edges.begin(), edges.begin() + 3}));
    // Of one odd edge the sign may be an error.
    CHECK_FALSE(symmetric_group_of_edges({even[0], even[1], even[2], odd[0]}));
    // Blocks, and one wrong edge that breaks them.
    std::vector<Permutation> blocks = moving_blocks(symmetric(10, 10), 3);
    blocks.push_back(then(blocks[0], blocks[1]));
    blocks.push_back(permutation(degree, {{0, 1, 2}}));
    CHECK_FALSE(shows_alternating(loops_of_edges(blocks)));
    blocks.push_back(odd[0]);
    CHECK(shows_alternating(loops_of_edges(blocks)));
    CHECK_FALSE(symmetric_group_of_edges(blocks));
}
