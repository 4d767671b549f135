#include "prover/library/seen_images.h"

#include "prover/solver/consistency.h"
#include "prover/system/exit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace plprove {

namespace {

template <class Numbers>
void require_finite(const Numbers& numbers, const std::string& place) {
    if (!std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); }))
        throw BadInput(place + ": give finite numbers");
}

Eigen::Matrix3d matrix(const pointline::Intrinsics& intrinsics, std::size_t view) {
    const std::string place = "camera " + std::to_string(view + 1);
    const auto& [fx, fy, cx, cy] = intrinsics;
    require_finite(std::array{fx, fy, cx, cy}, place);
    if (fx <= 0 || fy <= 0) throw BadInput(place + ": give positive focal lengths");
    Eigen::Matrix3d K;
    K << fx, 0, cx, 0, fy, cy, 0, 0, 1;
    return K;
}

/// Refuses what the view does not see by the problem, or does not have to be seen.
void require_seen(const Feature& feature, int view, const pointline::Sighting& sighting,
                  const std::string& place) {
    const auto expect = [&](bool sees, bool given, const std::string& what) {
        if (sees && !given) throw BadInput(place + ": give " + what);
        if (!sees && given) throw BadInput(place + ": leave " + what + " out");
    };
    expect(feature.sees_point(view), sighting.point.has_value(), "the point");
    // Lines through several points are not given: the points show them.
    const int shared = static_cast<int>(feature.shared.size());
    for (int line = shared; line < feature.lines; ++line) {
        const char letter = letter_of(feature, line);
        expect(feature.sees_line(view, line), sighting.lines.contains(letter),
               std::string("line ") + letter);
    }
    for (const auto& [letter, line] : sighting.lines) {
        if (letter < 'a' || letter >= 'a' + feature.lines - shared)
            throw BadInput(place + ": there is no line " + letter + ": leave it out");
        require_finite(line.coefficients, place);
        if (line.coefficients[0] == 0 && line.coefficients[1] == 0)
            throw BadInput(place + ": line " + letter + " is none: give other coefficients");
        for (const pointline::Point& point : line.points)
            require_finite(point, place);
    }
    if (sighting.point) require_finite(*sighting.point, place);
}

PixelLine pixel_line(const pointline::Line& line) {
    PixelLine result{Eigen::Map<const Eigen::Vector3d>(line.coefficients.data()), {}};
    for (const pointline::Point& point : line.points)
        result.points.emplace_back(point[0], point[1]);
    return result;
}

/// The sighting in normalised coordinates. Adds to `moved`.
Sighting normalised(const pointline::Sighting& given, const Eigen::Matrix3d& K, int lines,
                    double& moved) {
    std::optional<Eigen::Vector2d> point;
    if (given.point) point.emplace((*given.point)[0], (*given.point)[1]);
    std::vector<std::optional<PixelLine>> pixel_lines(static_cast<std::size_t>(lines));
    for (const auto& [letter, line] : given.lines)
        pixel_lines[static_cast<std::size_t>(letter - 'a')] = pixel_line(line);
    return normalised_sighting(point, pixel_lines, K, moved);
}

/// Refuses views with two points at the same place.
void require_different(const SeenImages& images) {
    if (const auto same = same_point(images.observation))
        throw BadInput("view " + std::to_string(same->view + 1) + " sees features " +
                       std::to_string(same->first + 1) + " and " +
                       std::to_string(same->second + 1) +
                       " at the same point: give images with different ones");
}

} // namespace

void require_images(const Features& problem, const pointline::Images& images) {
    const auto views = static_cast<std::size_t>(problem.front().views());
    if (!images.cameras.empty() && images.cameras.size() != views)
        throw BadInput("give intrinsics of " + std::to_string(views) + " cameras, or of none");
    if (images.features.size() != problem.size())
        throw BadInput("give " + std::to_string(problem.size()) + " features: these are " +
                       std::to_string(images.features.size()));
    for (std::size_t f = 0; f < problem.size(); ++f) {
        const std::string name = "feature " + std::to_string(f + 1);
        if (images.features[f].size() != views)
            throw BadInput(name + ": give what " + std::to_string(views) + " views see");
        for (std::size_t v = 0; v < views; ++v)
            require_seen(problem[f], static_cast<int>(v), images.features[f][v],
                         name + ", view " + std::to_string(v + 1));
    }
}

std::vector<Eigen::Matrix3d> calibration(const pointline::Images& images, int views) {
    std::vector<Eigen::Matrix3d> result(static_cast<std::size_t>(views),
                                        Eigen::Matrix3d::Identity());
    for (std::size_t v = 0; v < images.cameras.size(); ++v)
        result[v] = matrix(images.cameras[v], v);
    return result;
}

MovedImages seen_images(const Features& problem, const pointline::Images& images) {
    require_images(problem, images);
    MovedImages result;
    result.images.calibration = calibration(images, problem.front().views());
    for (std::size_t f = 0; f < problem.size(); ++f) {
        auto& sightings = result.images.observation.emplace_back();
        for (std::size_t v = 0; v < images.features[f].size(); ++v)
            sightings.push_back(normalised(images.features[f][v], result.images.calibration[v],
                                           problem[f].lines, result.moved));
    }
    require_different(result.images);
    return result;
}

} // namespace plprove
