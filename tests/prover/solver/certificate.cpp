// Images in integers of six digits: exactly those given, or as near as they say.
#include "prover/solver/certificate.h"

#include "prover/solver/images_file.h"
#include "prover/solver/synthetic.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <doctest/doctest.h>

using namespace plprove;

namespace {

using Eigen::Vector3d;

Vector3d vector(const IntegerVector& x) {
    return {static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(x[2])};
}

double angle(const Vector3d& a, const Vector3d& b) {
    return std::asin(std::min(1.0, a.normalized().cross(b.normalized()).norm()));
}

/// The largest angle between a point, or a line, of the integer images and what was given.
double largest_angle(const SolvePlan& plan, const CameraSystem& system,
                     const IntegerImages& integers, const Observation& observation) {
    double largest = 0;
    Vector3d point = Vector3d::Zero();
    for (std::size_t k = 0; k < system.free.size(); ++k) {
        const FreeVector& free = system.free[k];
        const SourceFeature& source = plan.sources[static_cast<std::size_t>(free.feature)];
        const auto view =
            static_cast<std::size_t>(plan.view_of[static_cast<std::size_t>(free.view)]);
        const Sighting& sighting = observation[source.feature][view];
        const Vector3d x = vector(integers.vectors[k]);
        if (free.line < 0) {
            point = x;
            largest = std::max(largest, angle(x, *sighting.point));
            continue;
        }
        const auto pin = static_cast<std::size_t>(source.pins[static_cast<std::size_t>(free.line)]);
        if (!sighting.lines[pin]) continue; // any line does
        largest = std::max(largest, angle(free.toward ? point.cross(x) : x, *sighting.lines[pin]));
    }
    return largest;
}

} // namespace

TEST_CASE("images in pixels have integer vectors nearby, as near as they say") {
    for (const char* text : {"2*Pa/Pa/Pa + P/P/P", "a/a/a + 3*P/P/P",
                             "Pa/a/Pa + Pa/Pa/a + "
                             "Pa/a/P + 3*P/-/P",
                             "a/P/P + P/P/P + a/a/a + 4*P/P/-"}) {
        CAPTURE(text);
        const SolvePlan how = plan(parse_problem(text));
        const CameraSystem system = camera_system(label_classes()[*how.number]);
        const GivenImages images =
            read_images(images_file(synthetic_scene(how.problem, 3)), "f", how.problem);
        const ConsistentImages exact = consistent(images);
        const IntegerImages integers = integer_images(how, system, exact);
        REQUIRE(integers.vectors.size() == system.free.size());
        CHECK(!integers.exact);
        CHECK(integers.moved < 1e-8);
        const double found =
            largest_angle(how, system, integers, rounded(images, exact).observation);
        CHECK(found > 0.5 * integers.moved);
        CHECK(found < 1.01 * integers.moved);
        for (const IntegerVector& x : integers.vectors)
            for (const int coordinate : x)
                CHECK(std::abs(coordinate) <= 999'999);
    }
}

TEST_CASE("images of few digits are kept exactly") {
    const std::string text = R"({"features": [
        {"views": [{"point": [0.25, -1.5]}, {"point": ["1/3", 2]}, {"point": [0.5, 0.125]}]},
        {"views": [{"point": [1, 2]}, {"point": [0.1, 0.2]}, {"point": [-3, 0.7]}]},
        {"views": [{"point": [-1, 1]}, {"point": [2, -0.3]}, {"point": [0.4, 0.9]}]},
        {"views": [{"lines": {"a": [1, 2, 3]}}, {"lines": {"a": [[0, 0.5], [1, 0]]}},
                   {"lines": {"a": [0.001, -1, 5]}}]}]})";
    const SolvePlan how = plan(parse_problem("3*P/P/P + a/a/a"));
    const CameraSystem system = camera_system(label_classes()[*how.number]);
    const GivenImages images = read_images(text, "f", how.problem);
    const IntegerImages integers = integer_images(how, system, consistent(images));
    CHECK(integers.exact);
    CHECK(integers.moved == 0);
    const auto has = [&](const IntegerVector& x) {
        const IntegerVector opposite{-x[0], -x[1], -x[2]};
        return std::ranges::count(integers.vectors, x) +
                   std::ranges::count(integers.vectors, opposite) ==
               1;
    };
    CHECK(has({1, -6, 4}));
    CHECK(has({1, 6, 3}));
    CHECK(has({4, 1, 8}));
    CHECK(has({1, 2, 3}));
    CHECK(has({1, 2, -1})); // x + 2 y = 1
    CHECK(has({1, -1000, 5000}));
}
