// A solution counts once, however many approximations of it there are.
#include "prover/many_views/distinct.h"

#include "prover/many_views/monodromy.h"
#include "prover/monodromy/solution_set.h"
#include "prover/problem/notation.h"

#include <doctest/doctest.h>

using namespace plprove;
using namespace plprove::many_views;

namespace {

const MonodromyResult& five_points() {
    static const MonodromyResult result = run_monodromy(parse_problem("5*P/P"), 1, {});
    REQUIRE(result.points.size() == 20);
    return result;
}

/// The point with all its coordinates changed, by so much relative to its size.
Point moved(const Point& point, double distance) {
    const double each =
        distance * (1 + point.norm()) / std::sqrt(static_cast<double>(point.size()));
    return point.array() + Complex(each);
}

} // namespace

TEST_CASE("approximations that Newton's method brings together are of one solution") {
    const MonodromyResult& found = five_points();
    std::vector<Point> points = found.points;
    SolutionSet<Point> apart(1e-7);
    for (const Point& point : found.points) {
        points.push_back(moved(point, 5e-7));
        apart.add(point);
        CHECK(!apart.find(points.back())); // as they are, they look different
    }
    const auto distinct = distinct_solutions(found.system, found.images, points);
    REQUIRE(distinct.size() == found.points.size());
    for (std::size_t i = 0; i < distinct.size(); ++i)
        CHECK(distinct[i] == found.points[i]);
}

TEST_CASE("different solutions, and points that lead far away, are kept") {
    const MonodromyResult& found = five_points();
    std::vector<Point> points = found.points;
    points.push_back(moved(found.points[0], 0.01));
    points.push_back(moved(found.points[0], 1e6));
    CHECK(distinct_solutions(found.system, found.images, points).size() == 22);
    CHECK(distinct_solutions(found.system, found.images, {}).empty());
}
