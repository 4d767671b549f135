// Solutions are told apart, by either measure of nearness.
#include "prover/multiview/solution_set.h"

#include <doctest/doctest.h>

using namespace plprove::multiview;

namespace {

Point point(double large, double small) {
    Point result(2);
    result << large, small;
    return result;
}

} // namespace

TEST_CASE("a solution is found again after small errors, by either measure") {
    for (const Nearness nearness : {Nearness::of_points, Nearness::of_coordinates}) {
        SolutionSet set(nearness);
        for (int i = 0; i < 50; ++i)
            CHECK(set.add(point(std::pow(-3.0, i % 7), i)) == i);
        CHECK(set.size() == 50);
        for (int i = 0; i < 50; ++i) {
            const double large = std::pow(-3.0, i % 7);
            CHECK(set.find(point(large * (1 + 1e-9), i + 1e-9)) == i);
        }
        CHECK(!set.find(point(2, 2)));
    }
}

TEST_CASE("solutions that share a large coordinate are different, coordinate by coordinate") {
    SolutionSet points, coordinates(Nearness::of_coordinates);
    for (SolutionSet* set : {&points, &coordinates})
        set->add(point(1e8, 1));
    CHECK(points.find(point(1e8, 4)) == 0);
    CHECK(!coordinates.find(point(1e8, 4)));
    CHECK(coordinates.find(point(1e8 + 1, 1)) == 0);
}
