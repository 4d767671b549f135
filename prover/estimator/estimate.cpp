#include "prover/estimator/estimate.h"

#include "prover/estimator/sampler.h"
#include "prover/solver/consistency.h"
#include "prover/system/in_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plprove {

namespace {

constexpr int batch = 8; ///< samples between two decisions whether to go on

/// What a match costs: (error / threshold)^2, at most 1.
template <class InSpace, class Match>
double cost(const std::optional<InSpace>& in_space, const Match& match, const Poses& cameras,
            const std::vector<PinholeIntrinsics>& intrinsics, double threshold) {
    if (!in_space) return 1;
    const double error = squared_error(*in_space, match, cameras, intrinsics);
    return error < threshold * threshold ? error / (threshold * threshold) : 1;
}

double point_cost(std::size_t index, const Poses& cameras, const Matches& matches,
                  double threshold) {
    const PointMatch& match = matches.points[index];
    return cost(space_point(match, cameras), match, cameras, matches.intrinsics, threshold);
}

double line_cost(std::size_t index, const Poses& cameras, const Matches& matches,
                 double threshold) {
    const LineMatch& match = matches.lines[index];
    return cost(space_line(match, cameras), match, cameras, matches.intrinsics, threshold);
}

/// The matches that test cameras.
Inliers tests_of(const Matches& matches) {
    Inliers result;
    for (std::size_t p = 0; p < matches.points.size(); ++p)
        if (tests_cameras(matches.points[p])) result.points.push_back(p);
    for (std::size_t l = 0; l < matches.lines.size(); ++l)
        if (tests_cameras(matches.lines[l])) result.lines.push_back(l);
    return result;
}

/// The sum of the costs of all tests; `bound` where it is as large.
double bounded_cost(const Poses& cameras, const Matches& matches, const Inliers& tests,
                    double threshold, double bound) {
    double sum = 0;
    for (const std::size_t p : tests.points)
        if ((sum += point_cost(p, cameras, matches, threshold)) >= bound) return bound;
    for (const std::size_t l : tests.lines)
        if ((sum += line_cost(l, cameras, matches, threshold)) >= bound) return bound;
    return sum;
}

/// What the views see of the sample; nothing where a view sees two points at the same place.
std::optional<SeenImages> images_of(const Sample& sample, const Features& problem,
                                    const Matches& matches) {
    SeenImages images;
    images.calibration.assign(matches.views(), Eigen::Matrix3d::Identity());
    for (std::size_t f = 0; f < sample.size(); ++f) {
        FeatureSightings& sightings = images.observation.emplace_back();
        for (std::size_t v = 0; v < matches.views(); ++v) {
            const int view = static_cast<int>(v);
            std::optional<Eigen::Vector2d> point;
            if (problem[f].has_point && problem[f].sees_point(view))
                point = matches.points[sample[f].point][v];
            std::vector<std::optional<PixelLine>> lines(sample[f].lines.size());
            for (std::size_t i = 0; i < lines.size(); ++i) {
                if (!problem[f].sees_line(view, static_cast<int>(i))) continue;
                const Segment& segment = *matches.lines[sample[f].lines[i]][v];
                lines[i] = line_through(segment.begin, segment.end);
            }
            double moved = 0;
            sightings.push_back(
                normalised_sighting(point, lines, Eigen::Matrix3d::Identity(), moved));
        }
    }
    if (same_point(images.observation)) return std::nullopt;
    return images;
}

/// How well cameras explain matches.
struct Consensus {
    Poses cameras;
    Inliers inliers;
    double cost = 0; ///< the sum of those of all tests
};

/// One search for the cameras of the matches.
class Search {
public:
    Search(const Matches& matches, const SampleSolver& solver, const EstimateOptions& options)
        : matches_(matches), solver_(solver), options_(options), tests_(tests_of(matches)),
          sampler_(solver.problem(), matches) {}

    std::optional<Estimate> run() {
        Consensus best;
        best.cost = static_cast<double>(tests_.points.size() + tests_.lines.size());
        double least = best.cost; // of cameras before they are refined
        int samples = 0;
        while (samples < options_.most_samples) {
            const int count = std::min(batch, options_.most_samples - samples);
            for (const Found& found : best_of_batch(samples, count, least)) {
                least = std::min(least, found.cost);
                Consensus better = optimised(found.cameras);
                if (better.cost < best.cost) best = std::move(better);
            }
            samples += count;
            if (samples >= options_.least_samples && samples >= samples_needed(best)) break;
        }
        if (!explains_more_than_a_sample(best)) return std::nullopt;
        return polished(best, samples);
    }

private:
    /// Cameras from a sample, as they are.
    struct Found {
        double cost = 0;
        Poses cameras;
    };

    const Features& problem() const { return solver_.problem(); }

    /// The best cameras of the samples that cost less than all before, the least first; at most a
    /// few, as to refine takes longer than a sample.
    std::vector<Found> best_of_batch(int first, int count, double bound) const {
        constexpr std::size_t most = 2;
        std::vector<Found> found(static_cast<std::size_t>(count));
        in_parts(found.size(), options_.threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                found[i] = best_of_sample(static_cast<std::uint64_t>(first) + i, bound);
        });
        std::erase_if(found, [](const Found& one) { return one.cameras.empty(); });
        std::ranges::stable_sort(found, {}, &Found::cost);
        if (found.size() > most) found.resize(most);
        return found;
    }

    /// The cameras of the sample that cost least, if less than `bound`; else no cameras.
    Found best_of_sample(std::uint64_t number, double bound) const {
        Found best{bound, {}};
        const auto sample = sampler_.draw(options_.seed, number);
        const auto images = sample ? images_of(*sample, problem(), matches_) : std::nullopt;
        if (!images) return best;
        for (Poses& cameras : solver_.solve(*images)) {
            const double cost =
                bounded_cost(cameras, matches_, tests_, options_.threshold, best.cost);
            if (cost < best.cost) best = {cost, std::move(cameras)};
        }
        return best;
    }

    /// How many samples make it as likely as the confidence that one of them is without wrong
    /// matches, and useful.
    double samples_needed(const Consensus& best) const {
        constexpr double useful = 0.5; // noise spoils the others
        double right = useful * solver_.success();
        for (std::size_t f = 0; f < problem().size(); ++f) {
            const std::vector<std::size_t>& pool = sampler_.candidates(f);
            right *= problem()[f].has_point ? share(best.inliers.points, tests_.points, pool)
                                            : share(best.inliers.lines, tests_.lines, pool);
            if (problem()[f].has_point)
                right *= std::pow(share(best.inliers.lines, tests_.lines, tests_.lines),
                                  problem()[f].lines);
        }
        return std::log(1 - options_.confidence) / std::log1p(-right);
    }

    /// Of those in the pool that are tests, how many are among the inliers: a share.
    static double share(const std::vector<std::size_t>& inliers,
                        const std::vector<std::size_t>& tests,
                        const std::vector<std::size_t>& pool) {
        const auto count = [&](const std::vector<std::size_t>& sorted) {
            return static_cast<double>(std::ranges::count_if(
                pool, [&](std::size_t i) { return std::ranges::binary_search(sorted, i); }));
        };
        const double all = count(tests);
        return all > 0 ? count(inliers) / all : 1;
    }

    /// What cameras explain of the matches.
    Consensus consensus(const Poses& cameras, double threshold) const {
        Consensus result{cameras, {}, 0};
        for (const std::size_t p : tests_.points) {
            const double cost = point_cost(p, cameras, matches_, threshold);
            result.cost += cost;
            if (cost < 1) result.inliers.points.push_back(p);
        }
        for (const std::size_t l : tests_.lines) {
            const double cost = line_cost(l, cameras, matches_, threshold);
            result.cost += cost;
            if (cost < 1) result.inliers.lines.push_back(l);
        }
        return result;
    }

    /// The cameras refined by what they explain, first with a wider threshold.
    Consensus optimised(const Poses& cameras) const {
        Consensus best = consensus(cameras, options_.threshold);
        Poses now = cameras;
        for (const double factor : {4.0, 2.0, 1.0, 1.0}) {
            const Inliers inliers = thinned(consensus(now, factor * options_.threshold).inliers);
            const auto better =
                refined(now, matches_, inliers, {factor * options_.threshold / 2, 10, false});
            if (!better) break;
            now = better->cameras;
            Consensus found = consensus(now, options_.threshold);
            if (found.cost < best.cost) best = std::move(found);
        }
        return best;
    }

    /// At most some 50 of each kind, which is enough on the way.
    static Inliers thinned(const Inliers& inliers) {
        constexpr std::size_t most = 50;
        const auto every = [](const std::vector<std::size_t>& all) {
            const std::size_t step = all.size() / most + 1;
            std::vector<std::size_t> some;
            for (std::size_t i = 0; i < all.size(); i += step)
                some.push_back(all[i]);
            return some;
        };
        return {every(inliers.points), every(inliers.lines)};
    }

    bool explains_more_than_a_sample(const Consensus& found) const {
        std::size_t features = 0;
        for (const Feature& feature : problem())
            features += static_cast<std::size_t>(feature.has_point + feature.lines);
        return found.inliers.points.size() + found.inliers.lines.size() > features;
    }

    /// Refined by all inliers, once at least, and until it explains no more.
    Estimate polished(const Consensus& best, int samples) const {
        constexpr int most_rounds = 5;
        const RefinementOptions options{options_.threshold / 2, 50, options_.covariance};
        Estimate result{best.cameras, best.inliers, samples, 0, {}};
        double cost = std::numeric_limits<double>::infinity();
        for (int round = 0; round < most_rounds; ++round) {
            const auto better = refined(result.cameras, matches_, result.inliers, options);
            if (!better) break;
            const Consensus found = consensus(better->cameras, options_.threshold);
            if (found.cost >= cost) break;
            cost = found.cost;
            result = {found.cameras, found.inliers, samples, better->rms, better->covariance};
        }
        return result;
    }

    const Matches& matches_;
    const SampleSolver& solver_;
    const EstimateOptions& options_;
    Inliers tests_;
    Sampler sampler_;
};

} // namespace

std::optional<Estimate> estimate(const Matches& matches, const SampleSolver& solver,
                                 const EstimateOptions& options) {
    return Search(matches, solver, options).run();
}

} // namespace plprove
