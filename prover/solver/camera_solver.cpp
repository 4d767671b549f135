#include "prover/solver/camera_solver.h"

#include "prover/monodromy/solution_set.h"
#include "prover/solver/alignment.h"
#include "prover/system/in_parts.h"
#include "prover/three_views/scene.h"

#include <atomic>
#include <cmath>

namespace plprove {

namespace {

/// Zeros are as accurate as that, relative to their sizes.
constexpr double accuracy = 1e-13;

/// So zeros are told apart that are very near each other, as those with nearly isotropic rotations
/// are where fields of view are narrow.
constexpr double near_zeros = 1e-11;

/// Corrections of approximate zeros below this, relative to the zero, may be rounding errors.
constexpr double rounding = 1e-11;

/// Newton's method is at rest where it moves a zero by no more, relative to the zero.
constexpr double at_rest = 1e-9;

/// Zeros that are no more than rounding errors away from being degenerate are no solutions.
constexpr double least_nondegeneracy = 1e-13;

Images complex_images(const std::vector<Eigen::Vector3d>& images) {
    Images result;
    for (const Eigen::Vector3d& x : images)
        result.push_back({x[0], x[1], x[2]});
    return result;
}

/// The zero that is the complex conjugate, which real images have, too.
CameraPoint conjugate(const CameraChart& chart, const CameraPoint& zero) {
    QuaternionCameras cameras = chart.cameras(zero);
    for (auto& quaternion : cameras.quaternion)
        for (Complex& x : quaternion)
            x = std::conj(x);
    for (Complex3& centre : cameras.centre)
        for (Complex& x : centre)
            x = std::conj(x);
    return chart.point(cameras);
}

/// Not a number compares with nothing, and would seem new.
bool is_finite(const CameraPoint& point) {
    return std::ranges::all_of(
        point, [](const Complex& x) { return std::isfinite(x.real()) && std::isfinite(x.imag()); });
}

/// The ends from all points, by `threads` threads. `work` takes points to ends, each by itself.
template <class Work>
PathFollower::Ends in_threads(const std::vector<CameraPoint>& points, unsigned threads,
                              const Work& work) {
    PathFollower::Ends ends(points.size());
    in_parts(points.size(), threads, [&](std::size_t begin, std::size_t end) {
        const std::vector<CameraPoint> part(points.data() + begin, points.data() + end);
        const PathFollower::Ends found = work(part);
        std::ranges::copy(found, ends.begin() + static_cast<std::ptrdiff_t>(begin));
    });
    return ends;
}

/// Drops ends that two paths share: one of the paths has jumped.
void drop_equal(PathFollower::Ends& ends) {
    SolutionSet<CameraPoint> seen(near_zeros);
    std::vector<std::size_t> first; // which path leads to each of them
    std::vector<std::size_t> equal;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (!ends[i]) continue;
        if (const auto known = seen.find(*ends[i])) {
            equal.push_back(i);
            equal.push_back(first[static_cast<std::size_t>(*known)]);
        } else {
            seen.add(*ends[i]);
            first.push_back(i);
        }
    }
    for (const std::size_t i : equal)
        ends[i].reset();
}

} // namespace

CameraSolver::CameraSolver(Start start)
    : start_(std::move(start)), system_(camera_system(label_classes()[start_.number])),
      tracked_(tracked_system(system_, start_.chart)),
      extension_(ExtensionSolver::make(label_classes()[start_.number])) {}

/// Zeros of images at rest, as they are found.
class CameraSolver::Search {
public:
    Search(const CameraSolver& solver, const Images& images, unsigned threads)
        : solver_(solver), threads_(threads),
          vectors_(image_vectors(solver.system_, solver.start_.constants, images)),
          at_rest_(moving_images(solver.system_, solver.start_.constants, images, images)) {}

    const SolutionSet<CameraPoint>& found() const { return found_; }
    bool is_complete() const { return found_.size() >= solver_.start_.degree(); }

    /// Adds the zeros to which these ends lead by Newton's method. Two paths rarely have the same
    /// end, if one has jumped: none of the two is returned.
    PathFollower::Ends add(PathFollower::Ends ends) {
        ends = polished(ends);
        drop_equal(ends);
        for (const auto& end : ends)
            if (end) add(*end);
        add_conjugates();
        return ends;
    }

    /// Adds the zeros that these cameras approximate.
    void add(const std::vector<QuaternionCameras>& approximations) {
        std::vector<CameraPoint> points;
        for (const QuaternionCameras& cameras : approximations) {
            const CameraPoint point = solver_.start_.chart.point(cameras);
            if (is_finite(point)) points.push_back(point);
        }
        const PathFollower::Ends ends =
            in_threads(points, [&](const auto& part) { return settled(part); });
        for (const auto& end : polished(ends))
            if (end) add(*end);
        add_conjugates();
    }

private:
    void add(const CameraPoint& zero) {
        if (!is_finite(zero)) return;
        const QuaternionCameras cameras = solver_.start_.chart.cameras(zero);
        if (nondegeneracy(solver_.system_, vectors_, cameras) > least_nondegeneracy &&
            !found_.find(zero))
            found_.add(zero);
    }

    /// Conjugates of solutions are solutions, too: some paths need not have arrived.
    void add_conjugates() {
        PathFollower::Ends conjugates;
        for (std::size_t i = conjugated_; i < found_.points().size() && !is_complete(); ++i) {
            const CameraPoint zero = conjugate(solver_.start_.chart, found_.points()[i]);
            if (!found_.find(zero)) conjugates.emplace_back(zero);
        }
        for (const auto& zero : polished(conjugates))
            if (zero) add(*zero);
        conjugated_ = found_.points().size();
    }

    /// In doubles where they are accurate enough; nothing where ends lead to no zero.
    PathFollower::Ends polished(const PathFollower::Ends& ends) const {
        return follow_on(ends, [&](const auto& zeros) {
            return in_threads(zeros, [&](const auto& part) { return accurate(part); });
        });
    }

    /// The zeros that these approximate, to all digits of doubles.
    PathFollower::Ends accurate(const std::vector<CameraPoint>& zeros) const {
        auto better = accurate_newton(accuracy, solver_.tracked_, at_rest_, zeros);
        fill(better, zeros, [&](const auto& open) { return in_double_doubles(open); });
        fill(better, zeros, [&](const auto& open) {
            return newton(fastest_triple_double_tracker(), 1e-22, solver_.tracked_, at_rest_, open);
        });
        return better;
    }

    /// Where Newton's method leads from rough approximations. Nothing where it comes to no rest: it
    /// may end anywhere when it starts far from a zero.
    PathFollower::Ends settled(std::vector<CameraPoint> open) const {
        constexpr int steps_in_doubles = 2, most_steps = 5;
        PathFollower::Ends result(open.size());
        std::vector<std::size_t> indices(open.size());
        for (std::size_t k = 0; k < indices.size(); ++k)
            indices[k] = k;
        for (int step = 0; step < most_steps && !open.empty(); ++step) {
            PathFollower::Ends ends(open.size());
            if (step < steps_in_doubles)
                ends = newton(fastest_tracker(), rounding, solver_.tracked_, at_rest_, open);
            fill(ends, open, [&](const auto& rest) { return in_double_doubles(rest); });
            std::vector<CameraPoint> moving;
            std::vector<std::size_t> indices_of_moving;
            for (std::size_t k = 0; k < ends.size(); ++k) {
                if (!ends[k]) continue;
                if (approximates(*ends[k], open[k], at_rest)) {
                    result[indices[k]] = ends[k];
                } else {
                    moving.push_back(*ends[k]);
                    indices_of_moving.push_back(indices[k]);
                }
            }
            open = std::move(moving);
            indices = std::move(indices_of_moving);
        }
        return result;
    }

    PathFollower::Ends in_double_doubles(const std::vector<CameraPoint>& zeros) const {
        return newton(fastest_double_double_tracker(), 1e-16, solver_.tracked_, at_rest_, zeros);
    }

    template <class Work>
    PathFollower::Ends in_threads(const std::vector<CameraPoint>& points, const Work& work) const {
        return plprove::in_threads(points, threads_, work);
    }

    const CameraSolver& solver_;
    unsigned threads_;
    std::vector<Complex3> vectors_;
    TrackedImages at_rest_;
    SolutionSet<CameraPoint> found_{near_zeros};
    std::size_t conjugated_ = 0; // the first zeros, whose conjugates are added
};

void CameraSolver::register_cameras(const std::vector<Eigen::Vector3d>& images,
                                    const SearchOptions& options, Search& search) const {
    const std::uint64_t most_attempts = options.effort == Effort::thorough ? 2 : 1;
    for (std::uint64_t attempt = 0; attempt < most_attempts && !search.is_complete(); ++attempt)
        search.add(extension_->cameras(system_, images, attempt, options.threads,
                                       options.effort == Effort::real
                                           ? ExtensionSolver::Wanted::real_in_front
                                           : ExtensionSolver::Wanted::all));
}

std::uint64_t CameraSolver::follow_paths(const Images& images, const SearchOptions& options,
                                         Search& search) const {
    const int most_ways = options.effort == Effort::thorough ? 3 : 1;
    Random random(0, start_.number);
    std::atomic<std::uint64_t> steps = 0;
    int before = 0; // where the second way finds nothing new, the third is no better
    for (int way = 0; way < most_ways && !search.is_complete(); ++way) {
        if (way >= 2 && search.found().size() == before) break;
        before = search.found().size();
        const Images to = way == 0 ? images : rephased(images, Phases::near_one, random);
        const TrackedImages straight = moving_images(system_, start_.constants, start_.images, to);
        const auto follow = [&](const std::vector<CameraPoint>& starts, const auto& way_of) {
            return in_threads(starts, options.threads, [&](const auto& part) {
                PathFollower follower(tracked_);
                auto ends = (follower.*way_of)(straight, part);
                steps += follower.counts().steps;
                return ends;
            });
        };
        const auto ends = search.add(follow(start_.solutions, &PathFollower::follow_quickly));
        if (options.effort == Effort::thorough && !search.is_complete())
            search.add(follow(without_end(start_.solutions, ends).first,
                              &PathFollower::follow_double_double));
    }
    return steps;
}

FoundCameras CameraSolver::solve(const std::vector<Eigen::Vector3d>& images,
                                 const SearchOptions& options) const {
    const Alignment alignment = align(system_, start_.images, images);
    Search search(*this, complex_images(alignment.turned), options.threads);
    if (options.templates && extension_) register_cameras(alignment.turned, options, search);
    std::uint64_t steps = 0;
    const bool has_cameras = options.effort == Effort::real ? extension_ && options.templates
                                                            : search.found().size() > 0;
    if (options.effort == Effort::thorough || !has_cameras)
        steps = follow_paths(alignment.nearest, options, search);
    FoundCameras result{{}, start_.degree() - search.found().size(), steps};
    for (const CameraPoint& zero : search.found().points())
        result.cameras.push_back(turned_back(alignment, start_.chart.cameras(zero)));
    return result;
}

} // namespace plprove
