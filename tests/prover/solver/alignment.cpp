// Turning images towards the start: nearer than before, and turned back exactly.
#include "prover/solver/alignment.h"

#include "prover/problem/signature.h"
#include "prover/three_views/random.h"

#include <Eigen/Geometry>
#include <doctest/doctest.h>

using namespace plprove;

namespace {

using Eigen::Vector3d;

Vector3d random_unit(Random& random) {
    const double x = random.real(), y = random.real(), z = random.real();
    return Vector3d(x, y, z).normalized();
}

double squared_distance(const Images& a, const Images& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
        for (std::size_t i = 0; i < 3; ++i)
            sum += std::norm(a[k][i] - b[k][i]);
    return sum;
}

/// Random images of the Chicago problem, and random images of a start.
struct Instance {
    CameraSystem system = camera_system(label_classes()[2394]);
    Images start;
    std::vector<Vector3d> images;

    explicit Instance(std::uint64_t seed) {
        Random random(seed, 0);
        for (std::size_t k = 0; k < system.free.size(); ++k) {
            const Complex3 x = random.complex3();
            start.push_back(x);
            images.push_back(random_unit(random));
        }
    }
};

} // namespace

TEST_CASE("aligned images are nearer to the start, and a small turn or phase takes them away") {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        CAPTURE(seed);
        const Instance instance(seed);
        const Alignment alignment = align(instance.system, instance.start, instance.images);
        const double least = squared_distance(alignment.nearest, instance.start);
        CHECK(least < squared_distance(complex_images(instance.images), instance.start));
        Random random(seed, 1);
        for (int probe = 0; probe < 20; ++probe) {
            Images moved = alignment.nearest;
            const auto k = static_cast<std::size_t>(random.bits() % instance.system.free.size());
            const Complex phase = std::polar(1.0, 0.01 * random.real());
            for (Complex& x : moved[k])
                x *= phase;
            CHECK(squared_distance(moved, instance.start) >= least * (1 - 1e-12));
        }
    }
}

TEST_CASE("the images are turned by rotations, view by view, and multiplied by phases") {
    const Instance instance(3);
    const Alignment alignment = align(instance.system, instance.start, instance.images);
    for (const Eigen::Matrix3d& turn : alignment.turn) {
        CHECK((turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-12);
        CHECK(turn.determinant() == doctest::Approx(1));
    }
    for (std::size_t k = 0; k < instance.images.size(); ++k) {
        const auto view = static_cast<std::size_t>(instance.system.free[k].view);
        const Vector3d turned = alignment.turn[view] * instance.images[k];
        CHECK((turned - alignment.turned[k]).norm() < 1e-12);
        const Complex3 nearest = alignment.nearest[k];
        const Complex3 exact{turned[0], turned[1], turned[2]};
        for (const Complex& x : cross(nearest, exact))
            CHECK(std::abs(x) < 1e-12);
    }
}

TEST_CASE("cameras are turned back: they see the scene where the images were") {
    const Instance instance(4);
    const Alignment alignment = align(instance.system, instance.start, instance.images);
    Random random(4, 2);
    QuaternionCameras cameras;
    for (auto& quaternion : cameras.quaternion)
        for (Complex& x : quaternion)
            x = random.complex();
    for (Complex3& centre : cameras.centre)
        centre = random.complex3();
    const QuaternionCameras back = turned_back(alignment.turn, cameras);
    // A point of the turned frame of camera 1, and the same point in the frame before.
    const Vector3d turned_point = random_unit(random);
    const Vector3d point = alignment.turn[0].transpose() * turned_point;
    const auto seen = [](const QuaternionCameras& by, std::size_t v, const Vector3d& x) {
        Complex3 offset;
        for (std::size_t i = 0; i < 3; ++i)
            offset[i] = x[static_cast<Eigen::Index>(i)] - by.centre[v][i];
        const Complex3 image = rotate(by.quaternion[v], offset);
        return Eigen::Vector3cd(image[0], image[1], image[2]);
    };
    for (std::size_t v = 0; v < 2; ++v) {
        const Eigen::Vector3cd before = seen(back, v, point);
        const Eigen::Vector3cd expected =
            alignment.turn[v + 1].transpose().cast<Complex>() * seen(cameras, v, turned_point);
        CHECK((before - expected).norm() < 1e-12 * expected.norm());
    }
}
