#include "prover/solver/camera_solver.h"

#include "prover/degree/scene.h"
#include "prover/degree/solution_set.h"
#include "prover/solver/alignment.h"

namespace plprove {

namespace {

/// Zeros are as accurate as that, relative to their sizes.
constexpr double accuracy = 1e-13;

/// So zeros are told apart that are very near each other, as those with nearly isotropic rotations
/// are where fields of view are narrow.
constexpr double near_zeros = 1e-11;

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

/// Drops ends that two paths share: one of the paths has jumped.
void drop_equal(PathFollower::Ends& ends) {
    SolutionSet seen(near_zeros);
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
      tracked_(tracked_system(system_, start_.chart)) {}

/// Zeros of images at rest, as they are found.
class CameraSolver::Search {
public:
    Search(const CameraSolver& solver, const Images& images)
        : solver_(solver), vectors_(image_vectors(solver.system_, solver.start_.constants, images)),
          at_rest_(moving_images(solver.system_, solver.start_.constants, images, images)) {}

    const SolutionSet& found() const { return found_; }
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

private:
    void add(const CameraPoint& zero) {
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
        std::vector<std::size_t> indices;
        std::vector<CameraPoint> zeros;
        for (std::size_t i = 0; i < ends.size(); ++i)
            if (ends[i]) {
                indices.push_back(i);
                zeros.push_back(*ends[i]);
            }
        auto better = accurate_newton(accuracy, solver_.tracked_, at_rest_, zeros);
        fill(better, zeros, [&](const auto& open) {
            return newton(fastest_double_double_tracker(), 1e-16, solver_.tracked_, at_rest_, open);
        });
        fill(better, zeros, [&](const auto& open) {
            return newton(fastest_triple_double_tracker(), 1e-22, solver_.tracked_, at_rest_, open);
        });
        PathFollower::Ends result(ends.size());
        for (std::size_t k = 0; k < zeros.size(); ++k)
            result[indices[k]] = better[k];
        return result;
    }

    const CameraSolver& solver_;
    std::vector<Complex3> vectors_;
    TrackedImages at_rest_;
    SolutionSet found_{near_zeros};
    std::size_t conjugated_ = 0; // so many zeros have their conjugates added
};

FoundCameras CameraSolver::solve(const std::vector<Eigen::Vector3d>& images, Effort effort) const {
    const int most_ways = effort == Effort::thorough ? 3 : 1;
    const Alignment alignment = align(system_, start_.images, images);
    Search search(*this, complex_images(alignment.turned));
    Random random(0, start_.number);
    PathFollower follower(tracked_);
    int before = -1; // where a way finds nothing new, others are no better
    for (int way = 0; way < most_ways && !search.is_complete() && search.found().size() != before;
         ++way) {
        before = search.found().size();
        const Images to =
            way == 0 ? alignment.nearest : rephased(alignment.nearest, Phases::near_one, random);
        const TrackedImages straight = moving_images(system_, start_.constants, start_.images, to);
        const auto ends = search.add(follower.follow_quickly(straight, start_.solutions));
        if (effort == Effort::thorough && !search.is_complete())
            search.add(
                follower.follow_double_double(straight, without_end(start_.solutions, ends).first));
    }
    FoundCameras result{{}, start_.degree() - search.found().size(), follower.counts().steps};
    for (const CameraPoint& zero : search.found().points())
        result.cameras.push_back(turned_back(alignment, start_.chart.cameras(zero)));
    return result;
}

} // namespace plprove
