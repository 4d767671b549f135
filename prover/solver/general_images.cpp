#include "prover/solver/general_images.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

namespace plprove {

namespace {

using Eigen::Vector3d;
using many_views::ViewImages;
using Vector = many_views::Vector<many_views::Complex>;

Vector complex(const Vector3d& x) {
    return {x[0], x[1], x[2]};
}

/// Along a line of the image, as long as 1.
Vector3d along(const Vector3d& line) {
    return Vector3d(-line[1], line[0], 0).normalized();
}

/// The point of the line that is nearest to the origin.
Vector3d foot(const Vector3d& line) {
    return Vector3d(0, 0, 1) -
           Vector3d(line[0], line[1], 0) * line[2] / line.head<2>().squaredNorm();
}

/// The factors of a point on the line through two others: the point is a (1 - s) + b s.
Vector factors(const Vector3d& x, const Vector3d& a, const Vector3d& b) {
    const double s = (x - a).dot(b - a) / (b - a).squaredNorm();
    return {1 - s, s, 0};
}

/// The points that a view sees, with the third coordinate 1.
std::vector<Vector3d> points_in(const Problem& problem, const Observation& observation,
                                std::size_t view) {
    std::vector<Vector3d> points;
    for (std::size_t p = 0; p < problem.points.size(); ++p)
        points.push_back(*observation[p][view].point / (*observation[p][view].point)[2]);
    return points;
}

ViewImages<many_views::Complex>
view_for_equations(const Problem& problem, const Observation& observation, std::size_t view) {
    const std::vector<Vector3d> points = points_in(problem, observation, view);
    ViewImages<many_views::Complex> result;
    for (std::size_t p = 0; p < points.size(); ++p) {
        const auto line = carrier(problem, static_cast<int>(p));
        if (!line) {
            result.points.push_back(complex(points[p]));
            continue;
        }
        const std::vector<int>& on_it = problem.lines[static_cast<std::size_t>(*line)].points;
        result.points.push_back(factors(points[p], points[static_cast<std::size_t>(on_it[0])],
                                        points[static_cast<std::size_t>(on_it[1])]));
    }
    // A point's pins are in the order of the problem's lines, and so are the free lines.
    std::vector<std::size_t> pins(points.size(), 0);
    std::size_t free_line = points.size();
    for (const Line& line : problem.lines) {
        auto& [first, second] = result.lines.emplace_back();
        if (line.points.empty()) {
            const Vector3d seen = *observation[free_line++][view].lines[0];
            first = complex(foot(seen));
            second = complex(foot(seen) + along(seen));
        } else if (line.points.size() == 1) {
            const auto point = static_cast<std::size_t>(line.points[0]);
            const auto& lines = observation[point][view].lines;
            const auto is_pin = [](const auto& seen) { return seen.has_value(); };
            const auto first_pin = std::ranges::find_if(lines, is_pin) - lines.begin();
            const Vector3d seen = *lines[static_cast<std::size_t>(first_pin) + pins[point]++];
            second = complex(points[point] + along(seen));
        }
    }
    return result;
}

/// What takes coordinates around 0 to those of the points and lines of a view.
Eigen::Matrix3d centring(const Observation& observation, std::size_t view) {
    std::vector<Eigen::Vector2d> places;
    for (const FeatureSightings& sightings : observation) {
        const Sighting& seen = sightings[view];
        if (seen.point) places.push_back(seen.point->hnormalized());
        if (seen.point) continue;
        for (const auto& line : seen.lines)
            if (line) places.push_back(foot(*line).hnormalized());
    }
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& place : places)
        middle += place / static_cast<double>(places.size());
    double size = 0;
    for (const Eigen::Vector2d& place : places)
        size = std::max(size, (place - middle).norm());
    Eigen::Matrix3d result = Eigen::Matrix3d::Identity();
    if (size > 0) result.topLeftCorner<2, 2>() *= size;
    result.topRightCorner<2, 1>() = middle;
    return result;
}

} // namespace

many_views::Images<many_views::Complex> images_for_equations(const Problem& problem,
                                                             const SeenImages& images) {
    many_views::Images<many_views::Complex> result;
    for (std::size_t view = 0; view < images.calibration.size(); ++view)
        result.push_back(view_for_equations(problem, images.observation, view));
    return result;
}

SeenImages centred(const SeenImages& images) {
    SeenImages result = images;
    for (std::size_t view = 0; view < images.calibration.size(); ++view) {
        const Eigen::Matrix3d K = centring(images.observation, view);
        result.calibration[view] = images.calibration[view] * K;
        for (FeatureSightings& sightings : result.observation) {
            Sighting& seen = sightings[view];
            if (seen.point) seen.point = K.inverse() * *seen.point;
            for (auto& line : seen.lines)
                if (line) line = (K.transpose() * *line).eval();
        }
    }
    return result;
}

} // namespace plprove
