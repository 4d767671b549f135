// Images in integers of 18 digits: exactly those given, or as near as they say.
#include "prover/solver/certificate.h"

#include "prover/solver/images_file.h"
#include "prover/solver/synthetic.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

using namespace plprove;

namespace {

ExactVector exactly(const IntegerVector& x) {
    return {mpq_class(x[0]), mpq_class(x[1]), mpq_class(x[2])};
}

mpq_class dot(const ExactVector& a, const ExactVector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

ExactVector exact_cross(const ExactVector& a, const ExactVector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The small angle between two vectors, by Lagrange's identity.
double angle(const ExactVector& a, const ExactVector& b) {
    const mpq_class squared_cosine = dot(a, b) * dot(a, b) / (dot(a, a) * dot(b, b));
    return std::sqrt(mpq_class(1 - squared_cosine).get_d());
}

/// The largest angle between a point, or a line, of the integer images and what was given.
double largest_angle(const SolvePlan& plan, const CameraSystem& system,
                     const IntegerImages& integers, const ConsistentImages& given) {
    double largest = 0;
    ExactVector point;
    for (std::size_t k = 0; k < system.free.size(); ++k) {
        const FreeVector& free = system.free[k];
        const SourceFeature& source = plan.sources[static_cast<std::size_t>(free.feature)];
        const auto view =
            static_cast<std::size_t>(plan.view_of[static_cast<std::size_t>(free.view)]);
        const ExactSighting& sighting = given.features[source.feature][view];
        const ExactVector x = exactly(integers.vectors[k]);
        if (free.line < 0) {
            point = x;
            largest = std::max(largest, angle(x, *sighting.point));
            continue;
        }
        const auto pin = static_cast<std::size_t>(source.pins[static_cast<std::size_t>(free.line)]);
        if (!sighting.lines[pin]) continue; // any line does
        const ExactVector line = free.toward ? exact_cross(point, x) : x;
        largest = std::max(largest, angle(line, *sighting.lines[pin]));
    }
    return largest;
}

/// The images, stretched a little, so that they have more digits than a file.
ConsistentImages with_many_digits(ConsistentImages images) {
    const mpq_class factor("79792266297612002/79792266297612001"); // 1 + 1/7^20
    for (auto& views : images.features)
        for (ExactSighting& sighting : views) {
            if (sighting.point) (*sighting.point)[0] *= factor;
            for (auto& line : sighting.lines)
                if (line) (*line)[0] /= factor;
        }
    return images;
}

} // namespace

TEST_CASE("images in pixels are kept exactly; of more digits, those nearby say how near") {
    for (const char* text : {"2*Pa/Pa/Pa + P/P/P", "a/a/a + 3*P/P/P",
                             "Pa/a/Pa + Pa/Pa/a + "
                             "Pa/a/P + 3*P/-/P",
                             "a/P/P + P/P/P + a/a/a + 4*P/P/-"}) {
        CAPTURE(text);
        const SolvePlan how = plan(parse_features(text));
        const CameraSystem system = camera_system(label_classes()[*how.number]);
        const GivenImages images =
            read_images(images_file(synthetic_scene(how.problem, 3)), "f", how.problem);
        const ConsistentImages pixels = consistent(images);
        const IntegerImages same = integer_images(how, system, pixels);
        CHECK(same.exact);
        CHECK(same.moved == 0);
        CHECK(largest_angle(how, system, same, pixels) == 0);
        const ConsistentImages exact = with_many_digits(pixels);
        const IntegerImages integers = integer_images(how, system, exact);
        REQUIRE(integers.vectors.size() == system.free.size());
        CHECK(!integers.exact);
        CHECK(integers.moved < 2e-18);
        CHECK(largest_angle(how, system, integers, exact) == doctest::Approx(integers.moved));
        for (const IntegerVector& x : integers.vectors)
            for (const std::int64_t coordinate : x)
                CHECK(std::abs(coordinate) <= 999'999'999'999'999'999);
    }
}

TEST_CASE("images of few digits are kept exactly") {
    const std::string text = R"({"features": [
        {"views": [{"point": [0.25, -1.5]}, {"point": ["1/3", 2]}, {"point": [0.5, 0.125]}]},
        {"views": [{"point": [1, 2]}, {"point": [0.1, 0.2]}, {"point": [-3, 0.7]}]},
        {"views": [{"point": [-1, 1]}, {"point": [2, -0.3]}, {"point": [0.4, 0.9]}]},
        {"views": [{"lines": {"a": [1, 2, 3]}}, {"lines": {"a": [[0, 0.5], [1, 0]]}},
                   {"lines": {"a": [0.001, -1, 5]}}]}]})";
    const SolvePlan how = plan(parse_features("3*P/P/P + a/a/a"));
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
