// Groups that keep solutions together which share an essential matrix (proofs/shared_matrices.md):
// of random permutations of a whole group, and of subgroups that are nearly the whole.
#include "checker/conclusion/group.h"
#include "prover/groups/cycle_types.h"
#include "prover/groups/permutation.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <random>

using namespace plprove;

namespace {

/// A permutation of blocks, and what it does inside of each before it moves the block.
struct OfBlocks {
    Permutation outer;
    std::vector<Permutation> inner;

    bool inner_is_even() const {
        return std::ranges::count_if(inner, [](const auto& one) { return !is_even(one); }) % 2 == 0;
    }
    /// The same as a permutation of all points.
    Permutation whole() const {
        Permutation result;
        for (std::size_t block = 0; block < outer.size(); ++block)
            for (const int point : inner[block])
                result.push_back(outer[block] * static_cast<int>(inner[block].size()) + point);
        return result;
    }
};

class Drawn {
public:
    Permutation permutation(int size) {
        Permutation result = identity(size);
        for (std::size_t k = as_index(size); k > 1; --k)
            std::swap(result[k - 1], result[random_() % k]);
        return result;
    }
    OfBlocks of_blocks(const Permutation& outer, int size) {
        OfBlocks result{outer, {}};
        for (std::size_t block = 0; block < outer.size(); ++block)
            result.inner.push_back(permutation(size));
        return result;
    }
    /// The first one that meets the condition.
    template <class Draw, class Meets>
    auto such(Draw draw, Meets meets) {
        auto one = draw();
        while (!meets(one))
            one = draw();
        return one;
    }

private:
    std::mt19937_64 random_;
};

/// What the prover finds, and the checker too.
std::string group_found(const std::vector<SharedCycles>& all, std::size_t degree) {
    checker::DegreeBounds bounds;
    bounds.at_least = degree;
    bounds.at_most = checker::UpperBound{degree, checker::ByForms{}};
    for (const auto& [solutions, matrices] : all)
        bounds.block_cycles.push_back(
            {0b011, {solutions.begin(), solutions.end()}, {matrices.begin(), matrices.end()}});
    const std::string group = plprove::group_with_blocks(all, static_cast<int>(degree));
    CHECK(group == checker::group_of(bounds));
    return group;
}

} // namespace

TEST_CASE("pairs that share a matrix: only the whole group shows itself") {
    constexpr int pairs = 6;
    Drawn drawn;
    const auto any = [&] { return drawn.of_blocks(drawn.permutation(pairs), 2); };
    const auto shown = [&](const auto& is_in_group) {
        int count = 0;
        for (int n = 0; n < 40; ++n) {
            std::vector<SharedCycles> all;
            for (int k = 0; k < 12; ++k) {
                const OfBlocks one = drawn.such(any, is_in_group);
                all.push_back({cycle_type(one.whole()), cycle_type(one.outer)});
            }
            const std::string group = group_found(all, 2 * pairs);
            CHECK((group.empty() || group == "S2 wr S6"));
            count += group.empty() ? 0 : 1;
        }
        return count;
    };
    CHECK(shown([](const OfBlocks&) { return true; }) > 30);
    CHECK(shown([](const OfBlocks& one) { return one.inner_is_even(); }) == 0);
    CHECK(shown([](const OfBlocks& one) { return one.inner_is_even() == is_even(one.outer); }) ==
          0);
    CHECK(shown([](const OfBlocks& one) { return is_even(one.outer); }) == 0);
    CHECK(shown([](const OfBlocks& one) { // the two points of all pairs, or of none, are exchanged
              return std::ranges::all_of(one.inner,
                                         [&](const auto& inner) { return inner == one.inner[0]; });
          }) == 0);
}

TEST_CASE("third cameras of twenty poses: only the whole group shows itself") {
    constexpr int twisted_pairs = 10, third_cameras = 8;
    Drawn drawn;
    const auto pose_permutation = [&] { // one of W
        return drawn.such([&] { return drawn.of_blocks(drawn.permutation(twisted_pairs), 2); },
                          [](const OfBlocks& one) { return one.inner_is_even(); });
    };
    const auto shown = [&](const auto& change) {
        int count = 0;
        for (int n = 0; n < 8; ++n) {
            std::vector<SharedCycles> all;
            for (int k = 0; k < 80; ++k) {
                const OfBlocks poses = pose_permutation();
                OfBlocks cameras = drawn.of_blocks(poses.whole(), third_cameras);
                change(poses, cameras);
                all.push_back({cycle_type(cameras.whole()), cycle_type(poses.outer)});
            }
            const std::string group = group_found(all, 160);
            CHECK((group.empty() || group == "<S8 wr S2 wr S10"));
            count += group.empty() ? 0 : 1;
        }
        return count;
    };
    const auto make_even = [](Permutation& inner) {
        if (!is_even(inner)) std::swap(inner[0], inner[1]);
    };
    CHECK(shown([](const OfBlocks&, OfBlocks&) {}) > 4);
    CHECK(shown([&](const OfBlocks&, OfBlocks& cameras) { // even ones for each pose
              std::ranges::for_each(cameras.inner, make_even);
          }) == 0);
    const auto with_sign = [](OfBlocks& cameras, bool even) {
        if (cameras.inner_is_even() != even) std::swap(cameras.inner[0][0], cameras.inner[0][1]);
    };
    CHECK(shown([&](const OfBlocks&, OfBlocks& cameras) { with_sign(cameras, true); }) == 0);
    CHECK(shown([&](const OfBlocks& poses, OfBlocks& cameras) {
              with_sign(cameras, is_even(poses.outer));
          }) == 0);
    CHECK(shown([&](const OfBlocks&, OfBlocks& cameras) { // pairs of third cameras
              for (Permutation& inner : cameras.inner)
                  inner = drawn.of_blocks(drawn.permutation(third_cameras / 2), 2).whole();
          }) == 0);
}
