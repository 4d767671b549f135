#include "prover/solver/zeros_at_rest.h"

#include "prover/three_views/path_follower.h"
#include "prover/three_views/scene.h"

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

/// The zero that is the complex conjugate, which real images have, too.
CameraPoint conjugate(const CameraChart& chart, const CameraPoint& zero) {
    return chart.point(plprove::conjugate(chart.cameras(zero)));
}

/// Not a number compares with nothing, and would seem new.
bool is_finite(const CameraPoint& point) {
    return std::ranges::all_of(
        point, [](const Complex& x) { return std::isfinite(x.real()) && std::isfinite(x.imag()); });
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

ZerosAtRest::ZerosAtRest(const ChartedEquations& equations, const Images& images, int most,
                         unsigned threads)
    : equations_(equations), threads_(threads), most_(most),
      vectors_(image_vectors(equations.system, equations.constants, images)),
      at_rest_(moving_images(equations.system, equations.constants, images, images)),
      found_(near_zeros) {}

ZerosAtRest::Ends ZerosAtRest::add(Ends ends) {
    ends = polished(ends);
    drop_equal(ends);
    for (const auto& end : ends)
        if (end) add(*end);
    add_conjugates();
    return ends;
}

void ZerosAtRest::add(const std::vector<QuaternionCameras>& approximations) {
    std::vector<CameraPoint> points;
    for (const QuaternionCameras& cameras : approximations) {
        const CameraPoint point = equations_.chart.point(cameras);
        if (is_finite(point)) points.push_back(point);
    }
    const Ends ends = in_threads(points, threads_, [&](const auto& part) { return settled(part); });
    for (const auto& end : polished(ends))
        if (end) add(*end);
    add_conjugates();
}

void ZerosAtRest::add(const CameraPoint& zero) {
    if (!is_finite(zero)) return;
    const QuaternionCameras cameras = equations_.chart.cameras(zero);
    if (nondegeneracy(equations_.system, vectors_, cameras) > least_nondegeneracy &&
        !found_.find(zero))
        found_.add(zero);
}

/// Conjugates of solutions are solutions, too: some paths need not have arrived.
void ZerosAtRest::add_conjugates() {
    Ends conjugates;
    for (std::size_t i = conjugated_; i < found_.points().size() && !is_complete(); ++i) {
        const CameraPoint zero = conjugate(equations_.chart, found_.points()[i]);
        if (!found_.find(zero)) conjugates.emplace_back(zero);
    }
    for (const auto& zero : polished(conjugates))
        if (zero) add(*zero);
    conjugated_ = found_.points().size();
}

/// In doubles where they are accurate enough; nothing where ends lead to no zero.
ZerosAtRest::Ends ZerosAtRest::polished(const Ends& ends) const {
    return follow_on(ends, [&](const auto& zeros) {
        return in_threads(zeros, threads_, [&](const auto& part) { return accurate(part); });
    });
}

/// The zeros that these approximate, to all digits of doubles.
ZerosAtRest::Ends ZerosAtRest::accurate(const std::vector<CameraPoint>& zeros) const {
    auto better = accurate_newton(accuracy, equations_.tracked, at_rest_, zeros);
    fill(better, zeros, [&](const auto& open) { return in_double_doubles(open); });
    fill(better, zeros, [&](const auto& open) {
        return newton(fastest_triple_double_tracker(), 1e-22, equations_.tracked, at_rest_, open);
    });
    return better;
}

/// Where Newton's method leads from rough approximations. Nothing where it comes to no rest: it
/// may end anywhere when it starts far from a zero.
ZerosAtRest::Ends ZerosAtRest::settled(std::vector<CameraPoint> open) const {
    constexpr int steps_in_doubles = 2, most_steps = 5;
    Ends result(open.size());
    std::vector<std::size_t> indices(open.size());
    for (std::size_t k = 0; k < indices.size(); ++k)
        indices[k] = k;
    for (int step = 0; step < most_steps && !open.empty(); ++step) {
        Ends ends(open.size());
        if (step < steps_in_doubles)
            ends = newton(fastest_tracker(), rounding, equations_.tracked, at_rest_, open);
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

ZerosAtRest::Ends ZerosAtRest::in_double_doubles(const std::vector<CameraPoint>& zeros) const {
    return newton(fastest_double_double_tracker(), 1e-16, equations_.tracked, at_rest_, zeros);
}

} // namespace plprove
