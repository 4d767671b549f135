#include "prover/library/pointline/estimator.h"

#include "prover/estimator/choices.h"
#include "prover/estimator/estimate.h"
#include "prover/estimator/sampler.h"
#include "prover/estimator/undistort.h"
#include "prover/library/guarded.h"
#include "prover/library/in_arrays.h"
#include "prover/problem/spec.h"
#include "prover/system/exit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

namespace pointline {

/// Solvers are made once for each problem.
struct Estimator::Content {
    std::mutex mutex;
    std::map<std::string, plprove::SampleSolver> solvers;

    const plprove::SampleSolver& solver(const plprove::Features& problem) {
        const std::lock_guard lock(mutex);
        const std::string name = plprove::notation(problem);
        const auto known = solvers.find(name);
        if (known != solvers.end()) return known->second;
        return solvers.try_emplace(name, problem).first->second;
    }
};

namespace {

using plprove::BadInput;

Eigen::Vector2d finite(const Point& point, const std::string& place) {
    if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
        throw BadInput(place + ": give finite numbers");
    return {point[0], point[1]};
}

/// What takes pixels of a view to normalised coordinates.
struct Lens {
    plprove::PinholeIntrinsics intrinsics;
    plprove::LensDistortion distortion;

    Eigen::Vector2d operator()(const Point& pixel, const std::string& place) const {
        const Eigen::Vector2d x =
            distortion.undistorted(intrinsics.normalised(finite(pixel, place)));
        if (!x.allFinite())
            throw BadInput(place + ": the lens shows no point there: give another distortion");
        return x;
    }
};

std::vector<Lens> lenses(const Matches& matches) {
    const std::size_t views = matches.cameras.size();
    if (views != 2 && views != 3)
        throw BadInput("give intrinsics of 2 or 3 cameras: these are " + std::to_string(views));
    if (!matches.distortions.empty() && matches.distortions.size() != views)
        throw BadInput("give distortions of " + std::to_string(views) + " cameras, or of none");
    std::vector<Lens> result;
    for (std::size_t v = 0; v < views; ++v) {
        const auto& [fx, fy, cx, cy] = matches.cameras[v];
        const Distortion d = matches.distortions.empty() ? Distortion{} : matches.distortions[v];
        const std::string place = "camera " + std::to_string(v + 1);
        for (const double x : {fx, fy, cx, cy, d.k1, d.k2, d.p1, d.p2, d.k3})
            if (!std::isfinite(x)) throw BadInput(place + ": give finite numbers");
        if (fx <= 0 || fy <= 0) throw BadInput(place + ": give positive focal lengths");
        result.push_back({{fx, fy, cx, cy}, {d.k1, d.k2, d.p1, d.p2, d.k3}});
    }
    return result;
}

/// What the views see of the points, or of the lines, each sighting as `convert` has it.
template <class Seen, class Convert>
auto sightings(const std::vector<std::vector<std::optional<Seen>>>& given, const char* kind,
               const std::vector<Lens>& lenses, Convert convert) {
    using Converted = decltype(convert(given[0][0].value(), lenses[0], std::string()));
    std::vector<std::vector<std::optional<Converted>>> result;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const std::string place = std::string(kind) + ' ' + std::to_string(i + 1);
        if (given[i].size() != lenses.size())
            throw BadInput(place + ": give what " + std::to_string(lenses.size()) + " views see");
        auto& seen = result.emplace_back(lenses.size());
        for (std::size_t v = 0; v < lenses.size(); ++v)
            if (given[i][v])
                seen[v] =
                    convert(*given[i][v], lenses[v], place + ", view " + std::to_string(v + 1));
    }
    return result;
}

std::vector<std::vector<std::size_t>> lines_through(const Matches& matches) {
    std::vector<std::vector<std::size_t>> result(matches.points.size());
    for (std::size_t i = 0; i < matches.incidences.size(); ++i) {
        const auto& [point, line] = matches.incidences[i];
        if (point >= matches.points.size() || line >= matches.lines.size())
            throw BadInput("incidence " + std::to_string(i + 1) +
                           ": there is no such point, or no such line: give their numbers, "
                           "counted from 0");
        result[point].push_back(line);
    }
    for (auto& lines : result) {
        std::ranges::sort(lines);
        lines.erase(std::ranges::unique(lines).begin(), lines.end());
    }
    return result;
}

plprove::Matches normalised(const Matches& matches) {
    const std::vector<Lens> views = lenses(matches);
    plprove::Matches result;
    for (const Lens& lens : views)
        result.intrinsics.push_back(lens.intrinsics);
    result.points = sightings(matches.points, "point", views,
                              [](const Point& seen, const Lens& lens, const std::string& place) {
                                  return lens(seen, place);
                              });
    result.lines = sightings(
        matches.lines, "line", views,
        [](const Segment& seen, const Lens& lens, const std::string& place) {
            const plprove::Segment segment{lens(seen.begin, place), lens(seen.end, place)};
            if (segment.begin == segment.end)
                throw BadInput(place + ": both points are equal: give two");
            return segment;
        });
    result.lines_through = lines_through(matches);
    return result;
}

plprove::EstimateOptions checked(const EstimatorOptions& options) {
    if (!(options.threshold > 0)) throw BadInput("give a threshold above 0 pixels");
    if (!(options.confidence > 0 && options.confidence < 1))
        throw BadInput("give a confidence between 0 and 1");
    if (options.most_samples < 1) throw BadInput("allow at least one sample");
    if (options.threads < 1) throw BadInput("give at least one thread");
    return {options.threshold, options.confidence, options.least_samples, options.most_samples,
            options.seed,      options.threads,    options.covariance};
}

/// The problem to sample. Throws BadInput where the matches do not have a sample of it.
plprove::Features problem_of(const std::string& wanted, const plprove::Matches& matches) {
    if (wanted == "auto") {
        const std::vector<plprove::Choice> offered = plprove::choices(matches);
        if (offered.empty())
            throw BadInput("the matches are too few for any problem on the list: give more, or "
                           "the incidences of points and lines");
        return offered.front().problem;
    }
    plprove::Features problem = plprove::parse_spec(wanted);
    if (static_cast<std::size_t>(problem.front().views()) != matches.views())
        throw BadInput(plprove::notation(problem) + " has " +
                       std::to_string(problem.front().views()) + " views, and the matches have " +
                       std::to_string(matches.views()) + ": give another problem");
    if (!plprove::Sampler(problem, matches).draw(0, 0))
        throw BadInput("the matches have no sample of " + plprove::notation(problem) +
                       ": give more, or another problem");
    return problem;
}

Estimate described(const plprove::Estimate& found, const plprove::Matches& matches) {
    Estimate result;
    for (const plprove::Pose<double>& pose : found.cameras)
        result.cameras.push_back(camera(pose));
    result.points.resize(matches.points.size());
    for (const std::size_t p : found.inliers.points)
        if (const auto point = plprove::space_point(matches.points[p], found.cameras))
            result.points[p] = vector(*point);
    result.lines.resize(matches.lines.size());
    for (const std::size_t l : found.inliers.lines)
        if (const auto line = plprove::space_line(matches.lines[l], found.cameras))
            // The point of the line that is nearest to the first camera.
            result.lines[l] =
                SpaceLine{vector(line->direction.cross(line->moment)), vector(line->direction)};
    result.samples = found.samples;
    result.rms = found.rms;
    for (const double entry : found.covariance.reshaped<Eigen::RowMajor>())
        result.covariance.push_back(entry);
    return result;
}

} // namespace

Estimator::Estimator() : content_(std::make_shared<Content>()) {}

Result<std::vector<Offer>> Estimator::offers(const Matches& matches) noexcept {
    return guarded<std::vector<Offer>>(Failure::bad_images, [&] {
        std::vector<Offer> result;
        for (const plprove::Choice& choice : plprove::choices(normalised(matches)))
            result.push_back({plprove::notation(choice.problem), choice.degree, choice.milliseconds,
                              choice.expected});
        return result;
    });
}

Result<Estimate> Estimator::estimate(const Matches& matches,
                                     const EstimatorOptions& options) const noexcept {
    auto found =
        guarded<std::optional<Estimate>>(Failure::bad_images, [&]() -> std::optional<Estimate> {
            const plprove::Matches seen = normalised(matches);
            const plprove::EstimateOptions how = checked(options);
            const plprove::Features problem = problem_of(options.problem, seen);
            const auto best = plprove::estimate(seen, content_->solver(problem), how);
            if (!best) return std::nullopt;
            Estimate result = described(*best, seen);
            result.problem = plprove::notation(problem);
            return result;
        });
    if (!found) return found.error();
    if (!*found)
        return Error{Failure::no_estimate,
                     "no sample leads to cameras that explain more matches than the sample: give "
                     "more matches, a larger threshold, or more samples"};
    return **found;
}

} // namespace pointline
