// Cameras from many matches: refinement, and samples of which some are wrong.
#include "prover/estimator/estimate.h"

#include "prover/problem/notation.h"
#include "scene.h"

#include <doctest/doctest.h>
#include <numeric>

using namespace plprove;

namespace {

Inliers all_of(const Matches& matches) {
    Inliers result;
    result.points.resize(matches.points.size());
    result.lines.resize(matches.lines.size());
    std::iota(result.points.begin(), result.points.end(), 0);
    std::iota(result.lines.begin(), result.lines.end(), 0);
    return result;
}

/// Cameras a few degrees and some per cent off.
Poses disturbed(Poses cameras) {
    cameras[1].R = Eigen::AngleAxisd(0.05, Eigen::Vector3d::UnitX()) * cameras[1].R;
    cameras[2].R = Eigen::AngleAxisd(-0.04, Eigen::Vector3d::UnitY()) * cameras[2].R;
    cameras[1].t = (cameras[1].t + Eigen::Vector3d(0.05, -0.03, 0.04)).normalized();
    cameras[2].t += Eigen::Vector3d(-0.03, 0.05, 0.02);
    return cameras;
}

double largest_error(const Poses& found, const Poses& truth) {
    double largest = 0;
    for (std::size_t v = 0; v < truth.size(); ++v)
        largest = std::max(
            {largest, angle_between(found[v].R, truth[v].R), (found[v].t - truth[v].t).norm()});
    return largest;
}

/// Every third match gets what the next one shows in view 3.
void spoil(Matches& matches) {
    for (std::size_t i = 0; i + 1 < matches.points.size(); i += 3)
        std::swap(matches.points[i][2], matches.points[i + 1][2]);
    for (std::size_t i = 0; i + 1 < matches.lines.size(); i += 3)
        std::swap(matches.lines[i][2], matches.lines[i + 1][2]);
}

/// The rotation vector w with exp(w) a = b, and the difference of the translations.
Eigen::Matrix<double, 6, 1> difference(const Pose<double>& a, const Pose<double>& b) {
    const Eigen::AngleAxisd turn(b.R * a.R.transpose());
    Eigen::Matrix<double, 6, 1> result;
    result << turn.angle() * turn.axis(), b.t - a.t;
    return result;
}

} // namespace

TEST_CASE("exact matches lead back from disturbed cameras to the true ones") {
    const Scene truth = scene(12, 4, 0, 5);
    Matches lines_only = truth.matches;
    for (auto& lines : lines_only.lines_through)
        lines.clear();
    for (const Matches& matches : {truth.matches, lines_only}) {
        const auto found =
            refined(disturbed(truth.cameras), matches, all_of(matches), {1000, 100, false});
        REQUIRE(found);
        CHECK(largest_error(found->cameras, truth.cameras) < 1e-6);
        CHECK(found->rms < 1e-4);
        CHECK(found->cameras[1].t.norm() == doctest::Approx(1));
        CHECK(found->covariance.size() == 0);
    }
    const auto by_lines = refined(disturbed(truth.cameras), truth.matches,
                                  {{}, all_of(truth.matches).lines}, {1000, 200, false});
    REQUIRE(by_lines);
    CHECK(largest_error(by_lines->cameras, truth.cameras) < 1e-5);
    CHECK(!refined(truth.cameras, truth.matches, {{0, 1}, {}}, {1, 10, false}));
}

TEST_CASE("the covariance is that of many draws of the noise") {
    constexpr int draws = 150;
    double squares = 0;
    Eigen::Matrix<double, 12, 1> sum_of_squares = Eigen::Matrix<double, 12, 1>::Zero();
    Eigen::Matrix<double, 12, 1> variances = Eigen::Matrix<double, 12, 1>::Zero();
    for (int draw = 0; draw < draws; ++draw) {
        // The scene stays, the noise differs.
        Scene truth = scene(15, 5, 0, 9);
        Random blur(100, static_cast<std::uint64_t>(draw));
        const auto add = [&](Eigen::Vector2d& x) {
            const double dx = gaussian(blur), dy = gaussian(blur);
            x += Eigen::Vector2d(dx, dy) * 0.5 / 800;
        };
        for (auto& point : truth.matches.points)
            for (auto& seen : point)
                add(*seen);
        for (auto& line : truth.matches.lines)
            for (auto& seen : line) {
                add(seen->begin);
                add(seen->end);
            }
        const auto found =
            refined(truth.cameras, truth.matches, all_of(truth.matches), {1000, 100, true});
        REQUIRE(found);
        REQUIRE(found->covariance.rows() == 12);
        Eigen::Matrix<double, 12, 1> error;
        error << difference(truth.cameras[1], found->cameras[1]),
            difference(truth.cameras[2], found->cameras[2]);
        sum_of_squares += error.cwiseProduct(error);
        variances += found->covariance.diagonal();
        // t of camera 2 moves on a sphere: eleven of twelve directions.
        squares +=
            error.dot(found->covariance.completeOrthogonalDecomposition().pseudoInverse() * error);
    }
    for (int i = 0; i < 12; ++i) {
        CAPTURE(i);
        CHECK(sum_of_squares[i] / variances[i] > 0.7);
        CHECK(sum_of_squares[i] / variances[i] < 1.4);
    }
    CHECK(squares / draws > 9.5);
    CHECK(squares / draws < 13);
}

TEST_CASE("a third of the matches is wrong, and the cameras are found") {
    Scene truth = scene(40, 20, 0.5, 11);
    spoil(truth.matches);
    const SampleSolver solver(parse_features("3*P/P/P + 2*P/P/-"));
    EstimateOptions options;
    options.most_samples = 200;
    options.covariance = true;
    const auto found = estimate(truth.matches, solver, options);
    REQUIRE(found);
    CHECK(largest_error(found->cameras, truth.cameras) < 0.02);
    CHECK(found->inliers.points.size() >= 12);
    for (const std::size_t p : found->inliers.points)
        CHECK((*space_point(truth.matches.points[p], found->cameras) - truth.points[p]).norm() <
              0.3);
    CHECK(found->rms < 1);
    CHECK(found->covariance.rows() == 12);
    // The same with other threads; another seed draws other samples.
    options.threads = 3;
    const auto again = estimate(truth.matches, solver, options);
    REQUIRE(again);
    CHECK(again->samples == found->samples);
    CHECK(largest_error(again->cameras, found->cameras) == 0);
    CHECK(again->inliers.points == found->inliers.points);
}

TEST_CASE("matches that are wrong alike explain nothing") {
    Matches matches = scene(8, 0, 0, 13).matches;
    Random random(1, 1);
    for (auto& point : matches.points)
        for (auto& seen : point)
            seen = Eigen::Vector2d(0.4 * random.real(), 0.3 * random.real());
    matches.lines.clear();
    for (auto& lines : matches.lines_through)
        lines.clear();
    const SampleSolver solver(parse_features("3*P/P/P + 2*P/P/-"));
    EstimateOptions options;
    options.threshold = 0.5;
    options.most_samples = 16;
    CHECK(!estimate(matches, solver, options));
}
