// Scenes of many points, each with a line through it, and of free lines, in front of three cameras.
#pragma once

#include "prover/estimator/structure.h"
#include "prover/three_views/random.h"

#include <Eigen/Geometry>

namespace plprove {

struct Scene {
    Poses cameras;
    std::vector<Eigen::Vector3d> points;
    std::vector<PluckerLine> lines; ///< line i passes through point i, as long as there are points
    Matches matches;
};

/// Sums of twelve: mean 0, variance 1.
inline double gaussian(Random& random) {
    double sum = 0;
    for (int i = 0; i < 12; ++i)
        sum += random.real() / 2;
    return sum;
}

inline Eigen::Vector3d random_vector(Random& random) {
    const double x = random.real(), y = random.real(), z = random.real();
    return {x, y, z};
}

/// Cameras with focal lengths of 800 pixels, the first [I | 0], the second 1 away. What they see is
/// off by `noise` pixels (standard deviation in each coordinate), all of it drawn independently.
inline Scene scene(std::size_t points, std::size_t free_lines, double noise, std::uint64_t seed) {
    const Random truth(seed, 0);
    Random random = truth, blur(seed, 1);
    Scene scene;
    scene.cameras.resize(3);
    const std::array<Eigen::Vector3d, 3> centres{
        Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.8, 0.6, 0), Eigen::Vector3d(-1.1, 0.2, 0.4)};
    const std::array<double, 3> angles{0, -0.2, 0.25};
    for (std::size_t v = 0; v < 3; ++v) {
        scene.cameras[v].R =
            Eigen::AngleAxisd(angles[v], Eigen::Vector3d(0.2, 1, 0.1).normalized()).matrix();
        scene.cameras[v].t = -scene.cameras[v].R * centres[v];
        scene.matches.intrinsics.push_back({800, 800, 320, 240});
    }
    const auto seen = [&](const Eigen::Vector3d& x, std::size_t v) {
        const Eigen::Vector3d image = scene.cameras[v].R * x + scene.cameras[v].t;
        const double dx = gaussian(blur), dy = gaussian(blur);
        return Eigen::Vector2d(image.hnormalized() + noise / 800 * Eigen::Vector2d(dx, dy));
    };
    for (std::size_t i = 0; i < points + free_lines; ++i) {
        const Eigen::Vector3d x = Eigen::Vector3d(0, 0, 5) + 1.5 * random_vector(random);
        const Eigen::Vector3d direction = random_vector(random).normalized();
        scene.lines.push_back({direction, x.cross(direction)});
        LineMatch& line = scene.matches.lines.emplace_back(3);
        for (std::size_t v = 0; v < 3; ++v)
            line[v] = Segment{seen(x - 0.3 * direction, v), seen(x + 0.4 * direction, v)};
        if (i >= points) continue;
        scene.points.push_back(x);
        PointMatch& point = scene.matches.points.emplace_back(3);
        for (std::size_t v = 0; v < 3; ++v)
            point[v] = seen(x, v);
        scene.matches.lines_through.push_back({i});
    }
    return scene;
}

/// In radians.
inline double angle_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
    return Eigen::AngleAxisd(a.transpose() * b).angle();
}

} // namespace plprove
