// Solutions are told apart, by either measure of nearness.
#include "prover/monodromy/solution_set.h"

#include <array>
#include <doctest/doctest.h>

using namespace plprove;

namespace {

using Point = std::array<std::complex<double>, 2>;

Point point(double large, double small) {
    return {large, small};
}

} // namespace

TEST_CASE("a solution is found again after small errors, by either measure") {
    for (const Nearness nearness : {Nearness::of_points, Nearness::of_coordinates}) {
        SolutionSet<Point> set(1e-7, nearness);
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
    SolutionSet<Point> points(1e-7), coordinates(1e-7, Nearness::of_coordinates);
    for (SolutionSet<Point>* set : {&points, &coordinates})
        set->add(point(1e8, 1));
    CHECK(points.find(point(1e8, 4)) == 0);
    CHECK(!coordinates.find(point(1e8, 4)));
    CHECK(coordinates.find(point(1e8 + 1, 1)) == 0);
}
