// Points and lines in space, for cameras that are known.
#include "prover/estimator/structure.h"

#include "prover/estimator/undistort.h"
#include "scene.h"

#include <doctest/doctest.h>
#include <limits>

using namespace plprove;

TEST_CASE("exact images give the point and the line that are there") {
    const Scene truth = scene(10, 0, 0, 1);
    for (std::size_t i = 0; i < 10; ++i) {
        const auto point = space_point(truth.matches.points[i], truth.cameras);
        REQUIRE(point);
        CHECK((*point - truth.points[i]).norm() < 1e-9);
        const auto line = space_line(truth.matches.lines[i], truth.cameras);
        REQUIRE(line);
        const double sign = line->direction.dot(truth.lines[i].direction);
        CHECK(std::abs(std::abs(sign) - 1) < 1e-9);
        CHECK((line->moment * sign - truth.lines[i].moment).norm() < 1e-8);
        CHECK(squared_error(*point, truth.matches.points[i], truth.cameras,
                            truth.matches.intrinsics) < 1e-12);
        CHECK(squared_error(*line, truth.matches.lines[i], truth.cameras,
                            truth.matches.intrinsics) < 1e-12);
    }
}

TEST_CASE("errors are distances in pixels") {
    Scene truth = scene(1, 0, 0, 2);
    auto& seen = *truth.matches.points[0][1];
    seen += Eigen::Vector2d(3, 4) / 800;
    CHECK(squared_error(truth.points[0], truth.matches.points[0], truth.cameras,
                        truth.matches.intrinsics) == doctest::Approx(25));
    // An end is moved by two pixels at a right angle to the line.
    Segment& segment = *truth.matches.lines[0][2];
    const Eigen::Vector2d along = (segment.end - segment.begin).normalized();
    segment.end += Eigen::Vector2d(-along.y(), along.x()) * 2 / 800;
    CHECK(squared_error(truth.lines[0], truth.matches.lines[0], truth.cameras,
                        truth.matches.intrinsics) == doctest::Approx(4));
    // Along the line it may be anywhere.
    segment.end = segment.begin + 5 * along;
    segment.begin -= along;
    CHECK(squared_error(truth.lines[0], truth.matches.lines[0], truth.cameras,
                        truth.matches.intrinsics) == doctest::Approx(0).epsilon(1e-9));
}

TEST_CASE("what is behind a camera, or seen once, is no point") {
    Scene truth = scene(1, 0, 0, 3);
    PointMatch match = truth.matches.points[0];
    match[0].reset();
    match[2].reset();
    CHECK(!space_point(match, truth.cameras));
    CHECK(!tests_cameras(match));
    // The centre of camera 2 mirrored: rays meet behind the cameras.
    Poses behind{{}, {Eigen::Matrix3d::Identity(), {-1, 0, 0}}};
    const PointMatch diverging{Eigen::Vector2d(-0.1, 0), Eigen::Vector2d(0.1, 0)};
    CHECK(!space_point(diverging, behind));
    Poses unknown = truth.cameras;
    unknown[1].t.x() = std::numeric_limits<double>::quiet_NaN();
    CHECK(!space_point(truth.matches.points[0], unknown));
    CHECK(!space_line(truth.matches.lines[0], unknown));
    const PointMatch parallel{Eigen::Vector2d(0.1, 0), Eigen::Vector2d(0.1, 0)};
    CHECK(!space_point(parallel, behind));
}

TEST_CASE("a line needs planes that differ") {
    const Poses cameras{{}, {Eigen::Matrix3d::Identity(), {-1, 0, 0}}};
    // Both planes contain the line between the centres.
    const Segment epipolar{{0, 0.2}, {0.5, 0.2}};
    CHECK(!space_line({epipolar, epipolar}, cameras));
    CHECK(!space_line({epipolar, std::nullopt}, cameras));
}

TEST_CASE("distortion is undone") {
    const LensDistortion lens{-0.28, 0.09, 0.001, -0.0007, 0.01};
    for (const double x : {-0.5, 0.0, 0.3, 0.6})
        for (const double y : {-0.4, 0.1, 0.45}) {
            const Eigen::Vector2d point(x, y);
            CHECK((lens.undistorted(lens.distorted(point)) - point).norm() < 1e-9);
        }
    // By hand: k1 = 1 moves (1, 0) to (2, 0), p1 = 1 moves (1, 1) by (2, 4).
    CHECK(LensDistortion{1, 0, 0, 0, 0}.distorted({1, 0}) == Eigen::Vector2d(2, 0));
    CHECK(LensDistortion{0, 0, 1, 0, 0}.distorted({1, 1}) == Eigen::Vector2d(3, 5));
}
