// Groups of classes by loops of images.
#include "prover/three_views/loop_group.h"
#include "prover/three_views/camera_loops.h"

#include <doctest/doctest.h>

using namespace plprove;

TEST_CASE("loops permute the solutions of Chicago in every way") {
    int last = 0;
    const auto found = group_of_loops(2394, 312, 0, [&](int loops) { last = loops; });
    REQUIRE(found);
    CHECK(found->group.name() == "S312");
    CHECK(found->loops == last);
}

TEST_CASE(
    "where two views share five points, 10 essential matrices and twisted pairs stay together") {
    const auto found = group_of_loops(4767, 160, 0);
    REQUIRE(found);
    CHECK(found->group.name() == "<S8 wr S2 wr S10");
    CHECK(found->group.order() == "8!^20*2!^10*10!/2");
    CHECK(found->group.width() == 10);
}

TEST_CASE("permutations are the same both ways, and on each run") {
    const CameraSystem system = camera_system(label_classes()[4]);
    const auto loops_of = [&](int degree) {
        return SolutionLoops(camera_monodromy(CameraLoops(system, 0, 4)), degree,
                             near_at_path_ends);
    };
    auto loops = loops_of(64), same = loops_of(64);
    REQUIRE(loops.complete());
    std::vector<Permutation> same_loops;
    for (int i = 0; i < 4; ++i) {
        const auto one = loops.next_both_ways(), other = same.next();
        REQUIRE(one);
        CHECK(one == other);
        CHECK(one->size() == 64);
        same_loops.push_back(*one);
    }
    // Edges whose paths are followed once give the loops that are followed anew.
    auto third = loops_of(64);
    third.add_bijections(4);
    REQUIRE(third.bijections().size() == 4);
    for (int i = 0; i < 3; ++i)
        CHECK(loops_of_edges(third.bijections())[as_index(i)] == same_loops[as_index(i)]);
    // Without all solutions there are no loops.
    CHECK_FALSE(loops_of(65).complete());
}
