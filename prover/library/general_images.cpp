#include "prover/library/seen_images.h"
#include "prover/solver/images.h"
#include "prover/system/exit.h"

namespace plprove {

namespace {

/// The numbers as they are.
GivenSighting exact(const pointline::Sighting& given, const Feature& feature) {
    GivenSighting result;
    if (given.point) result.point = ExactVector{(*given.point)[0], (*given.point)[1], 1};
    result.lines.resize(static_cast<std::size_t>(feature.lines));
    for (int line = static_cast<int>(feature.shared.size()); line < feature.lines; ++line) {
        const auto found = given.lines.find(letter_of(feature, line));
        if (found == given.lines.end()) continue;
        const auto& [a, b, c] = found->second.coefficients;
        GivenLine& exact = result.lines[static_cast<std::size_t>(line)].emplace();
        exact.coefficients = {a, b, c};
        for (const pointline::Point& point : found->second.points)
            exact.points.push_back({point[0], point[1]});
    }
    return result;
}

} // namespace

MovedImages seen_images(const Problem& problem, const pointline::Images& images) {
    if (problem.cameras == &projective_cameras && !images.cameras.empty())
        throw BadInput("the cameras are uncalibrated: give no intrinsics");
    GivenImages given{features_of(problem), problem, {}, {}, {}};
    require_images(given.problem, images);
    given.names.resize(given.problem.size());
    for (const Eigen::Matrix3d& K : calibration(images, problem.views))
        given.calibration.push_back({ExactVector{K(0, 0), K(0, 1), K(0, 2)},
                                     ExactVector{K(1, 0), K(1, 1), K(1, 2)},
                                     ExactVector{K(2, 0), K(2, 1), K(2, 2)}});
    for (std::size_t f = 0; f < given.problem.size(); ++f) {
        auto& views = given.features.emplace_back();
        for (const pointline::Sighting& sighting : images.features[f])
            views.push_back(exact(sighting, given.problem[f]));
    }
    refuse_degenerate(given);
    const ConsistentImages moved = consistent(given);
    return {rounded(given, moved), moved.moved};
}

} // namespace plprove
