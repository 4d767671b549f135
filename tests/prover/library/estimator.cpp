// Estimators by their public header alone.
#include <pointline/estimator.h>

#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <limits>

namespace {

constexpr pointline::Intrinsics K{700, 710, 300, 200};
constexpr pointline::Distortion lens{-0.2, 0.05, 0.001, -0.001, 0};

/// A grid of points on three sheets, seen by two cameras, the second turned by `angle`.
pointline::Matches two_views(double angle, bool distorted) {
    pointline::Matches matches{{K, K}, {}, {}, {}, {}};
    if (distorted) matches.distortions = {lens, lens};
    const double c = std::cos(angle), s = std::sin(angle);
    for (int i = 0; i < 27; ++i) {
        const double x = i % 3 - 1, y = i / 3 % 3 - 1, z = 5 + 0.7 * (i / 9) + 0.1 * (i % 5);
        auto& seen = matches.points.emplace_back();
        for (const std::array<double, 3>& p :
             {std::array{x, y, z}, std::array{c * x + s * z - 1, y, -s * x + c * z}}) {
            const double u = p[0] / p[2], v = p[1] / p[2], r2 = u * u + v * v;
            const auto& [k1, k2, p1, p2, k3] = distorted ? lens : pointline::Distortion{};
            const double radial = 1 + k1 * r2 + k2 * r2 * r2 + k3 * r2 * r2 * r2;
            const double du = 2 * p1 * u * v + p2 * (r2 + 2 * u * u);
            const double dv = p1 * (r2 + 2 * v * v) + 2 * p2 * u * v;
            seen.push_back(
                pointline::Point{K.fx * (u * radial + du) + K.cx, K.fy * (v * radial + dv) + K.cy});
        }
    }
    return matches;
}

pointline::Failure failure_of(const pointline::Matches& matches,
                              const pointline::EstimatorOptions& options = {}) {
    const auto estimate = pointline::Estimator().estimate(matches, options);
    REQUIRE(!estimate);
    CHECK(!estimate.error().message.empty());
    return estimate.error().failure;
}

} // namespace

TEST_CASE("two cameras from many points, with a distorting lens and without") {
    for (const bool distorted : {false, true}) {
        pointline::Matches matches = two_views(-0.2, distorted);
        (*matches.points[3][0])[1] += 50; // a wrong match
        matches.points[4][1].reset();     // no match
        const auto offers = pointline::Estimator::offers(matches);
        REQUIRE(offers);
        REQUIRE(offers->size() == 1);
        CHECK(offers->front().problem == "5*P/P");
        CHECK(offers->front().degree == 20);
        const auto estimate = pointline::Estimator().estimate(matches);
        REQUIRE(estimate);
        CHECK(estimate->problem == "5*P/P");
        CHECK(estimate->cameras[1].R[0] == doctest::Approx(std::cos(-0.2)));
        CHECK(estimate->cameras[1].R[2] == doctest::Approx(std::sin(-0.2)));
        CHECK(estimate->cameras[1].t[0] == doctest::Approx(-1));
        CHECK(!estimate->points[3]);
        CHECK(!estimate->points[4]);
        REQUIRE(estimate->points[0]);
        CHECK((*estimate->points[0])[2] == doctest::Approx(5).epsilon(1e-3));
        CHECK(estimate->rms < 0.01);
        CHECK(estimate->covariance.empty());
    }
}

TEST_CASE("no more samples are drawn than are allowed") {
    const auto estimate = pointline::Estimator().estimate(
        two_views(-0.2, false), {.least_samples = 11, .most_samples = 11, .threads = 4});
    REQUIRE(estimate);
    CHECK(estimate->samples == 11);
}

TEST_CASE("what is wrong with matches is said, as a value") {
    using pointline::Failure;
    const pointline::Matches good = two_views(-0.2, false);
    pointline::Matches bad = good;
    bad.cameras.pop_back();
    CHECK(failure_of(bad) == Failure::bad_images);
    bad = good;
    bad.distortions.resize(1);
    CHECK(failure_of(bad) == Failure::bad_images);
    bad = good;
    bad.points[2].pop_back();
    CHECK(failure_of(bad) == Failure::bad_images);
    bad = good;
    (*bad.points[2][0])[1] = std::numeric_limits<double>::infinity();
    CHECK(failure_of(bad) == Failure::bad_images);
    bad = good;
    bad.incidences = {{0, 0}};
    CHECK(failure_of(bad) == Failure::bad_images);
    bad = good;
    bad.lines.push_back({pointline::Segment{{1, 2}, {1, 2}}, std::nullopt});
    CHECK(failure_of(bad) == Failure::bad_images);
    bad = good;
    bad.points.resize(4);
    CHECK(failure_of(bad) == Failure::bad_images);
    CHECK(failure_of(good, {.threshold = 0}) == Failure::bad_images);
    CHECK(failure_of(good, {.confidence = 1}) == Failure::bad_images);
    CHECK(failure_of(good, {.most_samples = 0}) == Failure::bad_images);
    CHECK(failure_of(good, {.problem = "Chicago"}) == Failure::bad_images);
    CHECK(failure_of(good, {.problem = "what"}) == Failure::bad_problem);
    bad = good;
    bad.points.resize(5);
    CHECK(failure_of(bad) == Failure::no_estimate);
}
