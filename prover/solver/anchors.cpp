#include "prover/solver/anchors.h"

#include "prover/solver/alignment.h"
#include "prover/three_views/random.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

namespace plprove {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d in_cube(Random& random) {
    const double x = random.real(), y = random.real(), z = random.real();
    return {x, y, z};
}

/// A random direction.
Vector3d direction(Random& random) {
    while (true) {
        const Vector3d x = in_cube(random);
        if (const double square = x.squaredNorm(); square <= 1 && square > 0.01)
            return x / std::sqrt(square);
    }
}

Complex3 complex(const Vector3d& x) {
    return {x[0], x[1], x[2]};
}

/// Where three cameras are, and the middle of what they look at.
struct Stage {
    std::array<Vector3d, 3> centre;
    Vector3d middle;
};

Stage random_stage(Random& random) {
    constexpr double nearest = 3, farthest = 10; // in units of the distance of cameras 1 and 2
    const double inverse = 1 / farthest + (random.real() + 1) / 2 * (1 / nearest - 1 / farthest);
    const Vector3d forward = direction(random);
    return {{Vector3d::Zero(), Vector3d(1, 0, 0), 1.5 * in_cube(random)}, forward / inverse};
}

/// What the cameras see of points in a cube around the middle, and of lines through them.
std::vector<Vector3d> images_of(const CameraSystem& system, const Stage& stage, Random& random) {
    constexpr double size = 0.3; // of the distance of the middle
    std::vector<Vector3d> points;
    std::vector<std::vector<Vector3d>> directions;
    for (const Feature& feature : system.features) {
        points.push_back(stage.middle + size * stage.middle.norm() * in_cube(random));
        auto& lines = directions.emplace_back();
        for (int line = 0; line < feature.lines; ++line)
            lines.push_back(direction(random));
    }
    std::vector<Vector3d> images;
    for (const FreeVector& free : system.free) {
        const auto f = static_cast<std::size_t>(free.feature);
        const Vector3d ray =
            (points[f] - stage.centre[static_cast<std::size_t>(free.view)]).normalized();
        if (free.line < 0) {
            images.push_back(ray);
            continue;
        }
        const Vector3d normal =
            ray.cross(directions[f][static_cast<std::size_t>(free.line)]).normalized();
        images.push_back(free.toward ? normal.cross(ray) : normal);
    }
    return images;
}

/// Auxiliary lines are upright on epipolar planes, and auxiliary points near the middle of images:
/// so the equations are far from degenerate.
std::vector<Complex3> constants_of(const CameraSystem& system, const Stage& stage,
                                   const std::vector<Vector3d>& images) {
    std::vector<Complex3> constants(static_cast<std::size_t>(system.constants));
    for (const ImageVector& vector : system.vectors) {
        if (vector.kind != VectorKind::across) continue;
        const ImageVector& base = system.vectors[static_cast<std::size_t>(vector.base)];
        const Vector3d& x = images[static_cast<std::size_t>(base.base)];
        const Vector3d& centre = stage.centre[static_cast<std::size_t>(vector.view)];
        const bool is_point = system.free[static_cast<std::size_t>(base.base)].line < 0;
        Vector3d across = stage.middle - centre;
        if (is_point) across = vector.view == 0 ? stage.centre[1] : centre;
        constants[static_cast<std::size_t>(vector.other)] = complex(x.cross(across).normalized());
    }
    return constants;
}

/// The rotation R for which the trace of R^T M is largest (N. Higham, SIAM J. Sci. Stat. Comput. 7,
/// 1986); nothing where it is not the nearest orthogonal matrix.
std::optional<Matrix3d> nearest_rotation(Matrix3d m) {
    constexpr int most_steps = 20;
    constexpr double at_rest = 1e-10;
    for (int step = 0; step < most_steps; ++step) {
        Matrix3d cofactors;
        cofactors << m.col(1).cross(m.col(2)), m.col(2).cross(m.col(0)), m.col(0).cross(m.col(1));
        const double determinant = m.col(0).dot(cofactors.col(0));
        if (!(determinant > 1e-12 * m.squaredNorm() * m.norm())) return std::nullopt;
        const Matrix3d inverse = cofactors / determinant; // transposed
        const double scale = std::sqrt(inverse.norm() / m.norm());
        const Matrix3d next = (scale * m + inverse / scale) / 2;
        const double change = (next - m).squaredNorm();
        m = next;
        if (change < at_rest) break;
    }
    return m;
}

} // namespace

Anchor random_anchor(const CameraSystem& system, std::uint64_t number) {
    Random random(number, 0);
    const Stage stage = random_stage(random);
    Anchor anchor;
    anchor.images = images_of(system, stage, random);
    anchor.third = stage.centre[2];
    anchor.constants = constants_of(system, stage, anchor.images);
    return anchor;
}

AnchoredSolver::AnchoredSolver(const CameraSystem& system)
    : system_(system), tracked_(tracked_system(system, standard_chart())) {
    constexpr std::uint64_t count = 1000;
    for (std::uint64_t number = 0; number < count; ++number) {
        anchors_.push_back(random_anchor(system, number));
        alike_.push_back(towards(anchors_[0].images, anchors_.back().images).images);
    }
}

AnchoredSolver::Turned AnchoredSolver::towards(const std::vector<Vector3d>& target,
                                               const std::vector<Vector3d>& images) const {
    Turned result;
    result.turn.fill(Matrix3d::Identity());
    result.images = images;
    // Which of its signs a line has is open: the points turn the views first, with lines as they
    // come, which count little.
    for (const bool signs_are_known : {false, true}) {
        std::array<Matrix3d, 3> products;
        products.fill(Matrix3d::Zero());
        for (std::size_t k = 0; k < images.size(); ++k) {
            double weight = 1;
            if (system_.free[k].line >= 0) {
                weight = signs_are_known ? 1 : 0.01;
                if (result.images[k].dot(target[k]) < 0) weight = -weight;
            }
            products[static_cast<std::size_t>(system_.free[k].view)] +=
                weight * target[k] * images[k].transpose();
        }
        for (std::size_t v = 0; v < 3; ++v)
            if (const auto rotation = nearest_rotation(products[v])) result.turn[v] = *rotation;
        for (std::size_t k = 0; k < images.size(); ++k)
            result.images[k] =
                result.turn[static_cast<std::size_t>(system_.free[k].view)] * images[k];
    }
    return result;
}

double AnchoredSolver::similarity(const std::vector<Vector3d>& some,
                                  const std::vector<Vector3d>& others) const {
    double sum = 0;
    for (std::size_t k = 0; k < some.size(); ++k) {
        const double product = some[k].dot(others[k]);
        sum += system_.free[k].line >= 0 ? std::abs(product) : product;
    }
    return sum;
}

std::vector<std::size_t> AnchoredSolver::most_similar(const std::vector<Vector3d>& images,
                                                      std::size_t count) const {
    std::vector<double> by_anchor;
    for (const std::vector<Vector3d>& others : alike_)
        by_anchor.push_back(similarity(images, others));
    std::vector<std::size_t> order(anchors_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    count = std::min(count, order.size());
    const auto end = order.begin() + static_cast<std::ptrdiff_t>(count);
    std::ranges::partial_sort(order, end, [&](std::size_t a, std::size_t b) {
        return std::pair(-by_anchor[a], a) < std::pair(-by_anchor[b], b);
    });
    order.resize(count);
    return order;
}

TrackedImages AnchoredSolver::way(const Anchor& anchor, const std::vector<Vector3d>& to) const {
    // The same number for all images: other numbers, one for each, lead to the true cameras less
    // often.
    const Complex bend = Complex(1, 1) / std::sqrt(2.0);
    Images last;
    for (std::size_t k = 0; k < to.size(); ++k) {
        const bool other_sign = system_.free[k].line >= 0 && to[k].dot(anchor.images[k]) < 0;
        const Complex factor = other_sign ? -bend : bend;
        last.push_back({factor * to[k][0], factor * to[k][1], factor * to[k][2]});
    }
    return moving_images(system_, anchor.constants, complex_images(anchor.images), last);
}

std::vector<std::optional<QuaternionCameras>>
AnchoredSolver::follow(const std::vector<Vector3d>& images, std::size_t paths) const {
    // To turn views towards one anchor tells roughly which are near; these are then compared well.
    constexpr std::size_t compared = 4; // for each path
    struct Start {
        std::size_t anchor;
        Turned turned;
        double similarity;
    };
    std::vector<Start> starts;
    for (const std::size_t a :
         most_similar(towards(anchors_[0].images, images).images, compared * paths)) {
        Turned turned = towards(anchors_[a].images, images);
        const double similar = similarity(turned.images, anchors_[a].images);
        starts.push_back({a, std::move(turned), similar});
    }
    std::ranges::stable_sort(starts, std::greater(), &Start::similarity);
    if (starts.size() > paths) starts.resize(paths);

    std::vector<TrackedImages> ways;
    std::vector<CameraPoint> from, to(starts.size());
    for (const Start& start : starts) {
        const Anchor& anchor = anchors_[start.anchor];
        ways.push_back(way(anchor, start.turned.images));
        from.push_back({0, 0, 0, 0, 0, 0, 0, 0, anchor.third[0], anchor.third[1], anchor.third[2]});
    }
    TrackSettings settings;
    settings.prediction = 1e-2;
    settings.contraction = 0.3;
    settings.first_step = 0.05;
    settings.most_steps = 100; // a longer path is not worth it
    std::vector<TrackOutcome> outcomes(starts.size());
    fastest_tracker_of_each()(tracked_, ways.data(), settings, starts.size(), from.data(),
                              to.data(), outcomes.data());
    std::vector<std::optional<QuaternionCameras>> ends(starts.size());
    for (std::size_t i = 0; i < starts.size(); ++i)
        if (outcomes[i] == TrackOutcome::arrived)
            ends[i] = turned_back(starts[i].turned.turn, standard_chart().cameras(to[i]));
    return ends;
}

} // namespace plprove
