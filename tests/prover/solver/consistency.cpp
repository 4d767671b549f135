// Moving lines to the points that they miss: the nearest star is a minimum.
#include "prover/solver/consistency.h"

#include "prover/three_views/random.h"

#include <Eigen/Dense>
#include <doctest/doctest.h>
#include <numbers>

using namespace plprove;

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector2d random_point(Random& random) {
    const double x = 300 * random.real(), y = 300 * random.real();
    return {x, y};
}

/// The sum of squares that the nearest star minimises.
double cost(const Vector2d& point, const std::vector<PixelLine>& given, const Vector2d& moved,
            const std::vector<double>& angles) {
    double sum = (moved - point).squaredNorm();
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (given[i].points.empty()) {
            const Vector3d& l = given[i].coefficients;
            sum += std::pow(l.dot(moved.homogeneous()) / l.head<2>().norm(), 2);
            continue;
        }
        const Vector2d normal(std::cos(angles[i]), std::sin(angles[i]));
        for (const Vector2d& p : given[i].points)
            sum += std::pow(normal.dot(p - moved), 2);
    }
    return sum;
}

std::vector<double> angles_of(const PixelStar& star) {
    std::vector<double> angles;
    for (const Vector3d& line : star.lines)
        angles.push_back(std::atan2(line[1], line[0]));
    return angles;
}

} // namespace

TEST_CASE("lines that meet their point stay") {
    const Vector2d point(3, 4);
    const PixelStar star = nearest_star(
        point, {line_through(point, {10, -2}), line_through({1, 1}, {5, 7}), {{1, 2, -11}, {}}});
    CHECK(star.moved < 1e-12);
    CHECK((star.point - point).norm() < 1e-12);
}

TEST_CASE("the lines of the nearest star meet its point, and no star nearby is nearer") {
    Random random(5, 0);
    for (int trial = 0; trial < 50; ++trial) {
        CAPTURE(trial);
        const Vector2d point = random_point(random);
        std::vector<PixelLine> lines;
        for (int line = 0; line < 3; ++line) {
            const Vector2d noise = random_point(random) / 100;
            lines.push_back(line_through(point + noise, random_point(random)));
        }
        lines.push_back({random_point(random).homogeneous().cross((point).homogeneous()), {}});
        lines.back().coefficients[2] += 200 * random.real();
        const PixelStar star = nearest_star(point, lines);
        for (const Vector3d& line : star.lines)
            CHECK(std::abs(line.dot(star.point.homogeneous())) < 1e-9 * line.norm());
        const std::vector<double> angles = angles_of(star);
        const double least = cost(point, lines, star.point, angles);
        for (int probe = 0; probe < 50; ++probe) {
            std::vector<double> turned = angles;
            for (double& angle : turned)
                angle += 1e-3 * random.real();
            const Vector2d moved = star.point + random_point(random) / 3000;
            CHECK(cost(point, lines, moved, turned) >= least * (1 - 1e-9));
        }
    }
}

TEST_CASE("for one line the three points move to their common regression line") {
    // Of (0, 0), (4, 1), (8, 0) the line y = 1/3: the point moves up by 1/3.
    const PixelStar star = nearest_star({0, 0}, {line_through({4, 1}, {8, 0})});
    CHECK(star.point[1] == doctest::Approx(1.0 / 3));
    CHECK(star.point[0] == doctest::Approx(0));
    CHECK(star.moved == doctest::Approx(2.0 / 3));
}
