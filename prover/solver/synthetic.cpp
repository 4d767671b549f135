#include "prover/solver/synthetic.h"

#include "prover/three_views/random.h"

#include <Eigen/Geometry>
#include <cmath>
#include <nlohmann/json.hpp>

namespace plprove {

namespace {

using Eigen::Vector3d;

constexpr double distance_of_scene = 5;

Vector3d random_vector(Random& random) {
    const double x = random.real(), y = random.real(), z = random.real();
    return {x, y, z};
}

Eigen::Matrix3d calibration() {
    Eigen::Matrix3d K;
    K << 800, 0, 320, 0, 800, 240, 0, 0, 1;
    return K;
}

/// A camera with this centre that looks at the scene, roughly upright.
Pose<double> looking_at_scene(const Vector3d& centre, Random& random) {
    const Vector3d target = Vector3d(0, 0, distance_of_scene) + 0.3 * random_vector(random);
    const Vector3d forward = (target - centre).normalized();
    const Vector3d right = Vector3d(1, 0.2 * random.real(), 0);
    const Vector3d down = forward.cross(right).normalized();
    Pose<double> pose;
    pose.R << down.cross(forward).transpose(), down.transpose(), forward.transpose();
    pose.t = -pose.R * centre;
    return pose;
}

std::vector<Pose<double>> random_cameras(int views, Random& random) {
    std::vector<Pose<double>> cameras(1);
    const Vector3d second = random_vector(random).normalized();
    cameras.push_back(looking_at_scene(second, random));
    const Vector3d across = random_vector(random).cross(second).normalized();
    if (views >= 3) cameras.push_back(looking_at_scene(0.7 * second + across, random));
    while (std::ssize(cameras) < views)
        cameras.push_back(looking_at_scene(random_vector(random), random));
    return cameras;
}

Vector3d near_the_middle(Random& random) {
    return Vector3d(0, 0, distance_of_scene) + 1.5 * random_vector(random);
}

/// A point, or the next point of the line on which two points are already.
Vector3d next_point(const std::optional<Problem>& problem, const std::vector<Vector3d>& points,
                    Random& random) {
    const bool is_point = problem && points.size() < problem->points.size();
    const auto line = is_point ? carrier(*problem, static_cast<int>(points.size())) : std::nullopt;
    if (!line) return near_the_middle(random);
    const std::vector<int>& on_it = problem->lines[static_cast<std::size_t>(*line)].points;
    const Vector3d& a = points[static_cast<std::size_t>(on_it[0])];
    const Vector3d& b = points[static_cast<std::size_t>(on_it[1])];
    return (a + b) / 2 + 0.4 * random.real() * (b - a);
}

Sighting sighting(const Feature& feature, int view, const Pose<double>& camera,
                  const Vector3d& point, const std::vector<Vector3d>& directions) {
    Sighting result;
    const Vector3d x = camera.R * point + camera.t;
    if (feature.sees_point(view)) result.point = x / x[2];
    result.lines.resize(feature.shared.size()); // the points show these
    for (int line = static_cast<int>(feature.shared.size()); line < feature.lines; ++line) {
        result.lines.emplace_back();
        const Vector3d d = camera.R * directions[static_cast<std::size_t>(line)];
        if (feature.sees_line(view, line)) result.lines.back() = x.cross(d).normalized();
    }
    return result;
}

} // namespace

SyntheticScene synthetic_scene(const ImagedProblem& problem, std::uint64_t seed) {
    Random random(seed, 0);
    SyntheticScene scene;
    scene.problem = problem.features;
    scene.general = problem.general;
    const int views = problem.features.front().views();
    scene.cameras = random_cameras(views, random);
    scene.images.calibration.assign(static_cast<std::size_t>(views), calibration());
    for (const Feature& feature : problem.features) {
        scene.points.push_back(next_point(problem.general, scene.points, random));
        auto& directions = scene.directions.emplace_back();
        for (int line = 0; line < feature.lines; ++line)
            directions.push_back(random_vector(random).normalized());
        auto& views_of_feature = scene.images.observation.emplace_back();
        for (int view = 0; view < views; ++view)
            views_of_feature.push_back(sighting(feature, view,
                                                scene.cameras[static_cast<std::size_t>(view)],
                                                scene.points.back(), directions));
    }
    return scene;
}

namespace {

using Json = nlohmann::ordered_json;

/// To a millionth of a pixel.
double shown(double pixel) {
    return std::round(pixel * 1e6) / 1e6;
}

Json pixel(const Eigen::Matrix3d& K, const Vector3d& x) {
    const Vector3d image = K * x;
    return {shown(image[0] / image[2]), shown(image[1] / image[2])};
}

/// Two points of the line, about a hundred pixels apart: the first is `point` if the view sees it.
Json two_points(const Eigen::Matrix3d& K, const Vector3d& line,
                const std::optional<Vector3d>& point) {
    const Vector3d along = Vector3d(line[1], -line[0], 0).normalized() / 8;
    Vector3d first;
    if (point)
        first = *point / (*point)[2];
    else
        first = Vector3d(0, 0, 1) -
                Vector3d(line[0], line[1], 0) * line[2] / line.head<2>().squaredNorm();
    return {pixel(K, first), pixel(K, first + along)};
}

Json sighting_of(const Feature& feature, const Sighting& sighting, const Eigen::Matrix3d& K) {
    Json result;
    if (sighting.point) result["point"] = pixel(K, *sighting.point);
    for (std::size_t line = 0; line < sighting.lines.size(); ++line)
        if (sighting.lines[line])
            result["lines"][std::string(1, letter_of(feature, static_cast<int>(line)))] =
                two_points(K, *sighting.lines[line], sighting.point);
    return result;
}

} // namespace

std::string images_file(const SyntheticScene& scene) {
    const std::string problem = scene.general ? notation(*scene.general) : notation(scene.problem);
    Json json{{"problem", problem}, {"cameras", Json::array()}, {"features", Json::array()}};
    for (const Eigen::Matrix3d& K : scene.images.calibration)
        json["cameras"].push_back(
            {{"fx", K(0, 0)}, {"fy", K(1, 1)}, {"cx", K(0, 2)}, {"cy", K(1, 2)}});
    if (scene.general && scene.general->cameras == &projective_cameras) json.erase("cameras");
    for (std::size_t f = 0; f < scene.problem.size(); ++f) {
        const FeatureSightings& sightings = scene.images.observation[f];
        Json views = Json::array();
        for (std::size_t v = 0; v < sightings.size(); ++v)
            views.push_back(
                sighting_of(scene.problem[f], sightings[v], scene.images.calibration[v]));
        json["features"].push_back({{"views", views}});
    }
    return json.dump(2) + '\n';
}

} // namespace plprove
