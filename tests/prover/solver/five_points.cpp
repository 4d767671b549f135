// The five-point solver against the law that it solves, and against the number of its solutions.
#include "prover/solver/five_points.h"

#include "prover/problem/notation.h"
#include "prover/solver/synthetic.h"

#include <Eigen/Dense>
#include <doctest/doctest.h>

using namespace plprove;

namespace {

using Points = std::array<Eigen::Vector3d, 5>;

Points points_in(const SyntheticScene& scene, std::size_t view) {
    Points points;
    for (std::size_t k = 0; k < 5; ++k)
        points[k] = *scene.images.observation[k][view].point;
    return points;
}

} // namespace

TEST_CASE("20 different poses whose rays meet, and which come in conjugate pairs") {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        CAPTURE(seed);
        const SyntheticScene scene = synthetic_scene(parse_features("5*P/P"), seed);
        const Points x = points_in(scene, 0), y = points_in(scene, 1);
        const auto poses = five_point_poses(x, y);
        REQUIRE(poses.size() == 20);
        for (const ComplexPose& pose : poses) {
            const double size = pose.R.norm();
            CHECK((pose.R * pose.R.transpose() - Eigen::Matrix3cd::Identity()).norm() <
                  1e-8 * size * size);
            CHECK(std::abs(pose.R.determinant() - 1.0) < 1e-8 * size * size * size);
            for (std::size_t k = 0; k < 5; ++k) {
                Eigen::Matrix3cd rows;
                rows << (pose.R * x[k]).transpose(), y[k].transpose().cast<std::complex<double>>(),
                    pose.t.transpose();
                CHECK(std::abs(rows.determinant()) < 1e-9 * (1 + size) * pose.t.norm());
            }
            int conjugates = 0, equal = 0;
            for (const ComplexPose& other : poses) {
                conjugates += (other.R.conjugate() - pose.R).norm() < 1e-6 * size;
                equal += (other.R - pose.R).norm() < 1e-6 * size;
            }
            CHECK(conjugates == 1);
            CHECK(equal == 1);
        }
    }
}

TEST_CASE("equal points leave no pencil of essential matrices") {
    const SyntheticScene scene = synthetic_scene(parse_features("5*P/P"), 1);
    Points x = points_in(scene, 0), y = points_in(scene, 1);
    x[4] = x[3];
    y[4] = y[3];
    CHECK(five_point_poses(x, y).empty());
}
