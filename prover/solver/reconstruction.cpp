#include "prover/solver/reconstruction.h"

#include "prover/solver/bilinear.h"
#include "prover/solver/decompositions.h"
#include "prover/solver/poses.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace plprove {

namespace {

constexpr double rounding = 1e-9; ///< what is smaller, relative to 1, determines nothing

template <class S>
using Rows = Eigen::Matrix<S, Eigen::Dynamic, 3>;

/// Linear equations a·X = b for a point X of space.
template <class S>
struct PointEquations {
    std::vector<Vector<S>> a;
    std::vector<S> b;

    /// X is in the plane of an image line.
    void add_plane(const Pose<S>& pose, const Eigen::Vector3d& line) {
        const Vector<S> l = line.normalized().cast<S>();
        a.push_back(pose.R.transpose() * l);
        b.push_back(-l.cwiseProduct(pose.t).sum());
    }

    /// X is on the ray of an image point.
    void add_ray(const Pose<S>& pose, const Eigen::Vector3d& point) {
        for (int axis = 0; axis < 3; ++axis) {
            const Eigen::Vector3d line = point.normalized().cross(Eigen::Vector3d::Unit(axis));
            if (line.norm() > 0.1) add_plane(pose, line);
        }
    }

    Rows<S> matrix() const {
        Rows<S> rows(static_cast<Eigen::Index>(a.size()), 3);
        for (std::size_t i = 0; i < a.size(); ++i)
            rows.row(static_cast<Eigen::Index>(i)) = a[i].transpose();
        return rows;
    }

    /// The point nearest to all conditions; nothing where they leave it open.
    std::optional<Vector<S>> solve() const {
        if (a.size() < 3) return std::nullopt;
        const Eigen::Map<const Eigen::Matrix<S, Eigen::Dynamic, 1>> right(
            b.data(), static_cast<Eigen::Index>(b.size()));
        const auto point = least_squares<S>(matrix(), right, rounding);
        if (!point) return std::nullopt;
        return Vector<S>(point->col(0));
    }
};

template <class S>
std::optional<Vector<S>> space_point(const FeatureSightings& sightings,
                                     const std::vector<Pose<S>>& poses) {
    PointEquations<S> equations;
    bool seen = false;
    for (std::size_t v = 0; v < poses.size(); ++v) {
        seen = seen || sightings[v].point.has_value();
        if (sightings[v].point) equations.add_ray(poses[v], *sightings[v].point);
        for (const auto& line : sightings[v].lines)
            if (line) equations.add_plane(poses[v], *line);
    }
    return seen ? equations.solve() : std::nullopt;
}

template <class S>
struct LineInSpace {
    Vector<S> point, direction;
};

/// The meet of the planes of an image line in the views that see it, through the point if there is
/// one; nothing where fewer than two views see it.
template <class S>
std::optional<LineInSpace<S>> space_line(const FeatureSightings& sightings, std::size_t line,
                                         const std::optional<Vector<S>>& point,
                                         const std::vector<Pose<S>>& poses) {
    PointEquations<S> planes;
    for (std::size_t v = 0; v < poses.size(); ++v)
        if (sightings[v].lines[line]) planes.add_plane(poses[v], *sightings[v].lines[line]);
    if (planes.a.size() < 2) return std::nullopt;
    const Rows<S> normals = planes.matrix();
    const Eigen::JacobiSVD<Eigen::Matrix<S, 3, 3>> decomposition(normals.adjoint() * normals,
                                                                 Eigen::ComputeFullV);
    // These singular values are squares.
    if (decomposition.singularValues()[1] < rounding * rounding) return std::nullopt;
    const Vector<S> direction = decomposition.matrixV().col(2);
    if (point) return LineInSpace<S>{*point, direction};
    // The point of the line that is nearest to the origin.
    planes.a.push_back(direction.conjugate());
    planes.b.push_back(S(0));
    const auto nearest = planes.solve();
    if (!nearest) return std::nullopt;
    return LineInSpace<S>{*nearest, direction};
}

/// The distance in pixels between the image of a point and what was seen.
template <class S>
double point_residual(const Vector<S>& point, const Pose<S>& pose, const Eigen::Matrix3d& K,
                      const Eigen::Vector3d& seen) {
    const Vector<S> image = K.cast<S>() * (pose.R * point + pose.t);
    const Eigen::Vector3d pixel = K * seen;
    const Vector<S> difference = image / image[2] - (pixel / pixel[2]).cast<S>();
    return difference.norm();
}

/// How far the image of a line is, in pixels, from two points of the line that was seen: the one
/// that is nearest to the principal point, and one at a distance of a focal length from it.
template <class S>
double line_residual(const LineInSpace<S>& line, const Pose<S>& pose, const Eigen::Matrix3d& K,
                     const Eigen::Vector3d& seen) {
    const Vector<S> point = pose.R * line.point + pose.t;
    const Vector<S> direction = pose.R * line.direction;
    Vector<S> image = bilinear_cross<S>(point, direction);
    image = (K.inverse().transpose().cast<S>() * image).eval();
    image /= image.template head<2>().norm();
    const Eigen::Vector3d across(seen[0], seen[1], 0);
    const Eigen::Vector3d along(-seen[1], seen[0], 0);
    const Eigen::Vector3d foot = Eigen::Vector3d(0, 0, 1) - across * seen[2] / across.squaredNorm();
    double largest = 0;
    for (const double distance : {0.0, 1.0}) {
        const Eigen::Vector3d pixel = K * (foot + distance * along.normalized());
        largest = std::max(largest, std::abs(image.cwiseProduct(pixel.cast<S>()).sum()));
    }
    return largest;
}

template <class S>
double feature_residual(const SeenImages& images, std::size_t feature,
                        const std::optional<Vector<S>>& point,
                        const std::vector<std::optional<LineInSpace<S>>>& lines,
                        const std::vector<Pose<S>>& poses) {
    double largest = 0;
    for (std::size_t v = 0; v < poses.size(); ++v) {
        const Sighting& sighting = images.observation[feature][v];
        const Eigen::Matrix3d& K = images.calibration[v];
        if (point && sighting.point)
            largest = std::max(largest, point_residual(*point, poses[v], K, *sighting.point));
        for (std::size_t line = 0; line < lines.size(); ++line)
            if (lines[line] && sighting.lines[line])
                largest = std::max(largest,
                                   line_residual(*lines[line], poses[v], K, *sighting.lines[line]));
    }
    return largest;
}

template <class S>
Solution reconstruct(const SeenImages& images, const std::vector<Pose<S>>& poses) {
    using C = std::complex<double>;
    Solution solution;
    for (const Pose<S>& pose : poses)
        solution.cameras.push_back({pose.R.template cast<C>(), pose.t.template cast<C>()});
    for (std::size_t f = 0; f < images.observation.size(); ++f) {
        const FeatureSightings& sightings = images.observation[f];
        const std::optional<Vector<S>> point = space_point(sightings, poses);
        std::vector<std::optional<LineInSpace<S>>> lines;
        SpaceFeature& feature = solution.features.emplace_back();
        if (point) feature.point = point->template cast<C>();
        for (std::size_t line = 0; line < sightings[0].lines.size(); ++line) {
            const auto& found = lines.emplace_back(space_line(sightings, line, point, poses));
            feature.lines.emplace_back();
            if (found)
                feature.lines.back() = {found->point.template cast<C>(),
                                        found->direction.template cast<C>()};
        }
        feature.in_front.resize(poses.size());
        solution.residual =
            std::max(solution.residual, feature_residual(images, f, point, lines, poses));
    }
    return solution;
}

/// Whether the point is in front of the camera that sees it there.
bool is_in_front(const Eigen::Vector3d& point, const Pose<double>& pose,
                 const Eigen::Vector3d& seen) {
    return (pose.R * point + pose.t).dot(seen) * seen[2] > 0;
}

/// Takes the scene and the centres of the cameras to the other side of the centre of camera 1. The
/// images stay what they are.
void reflect(Solution& solution) {
    for (ComplexPose& pose : solution.cameras)
        pose.t = -pose.t;
    for (SpaceFeature& feature : solution.features) {
        if (feature.point) *feature.point = -*feature.point;
        for (auto& line : feature.lines)
            if (line) line->point = -line->point;
    }
}

/// Marks what is in front. Returns how many more points are behind cameras than in front of them.
int mark_in_front(const SeenImages& images, const std::vector<Pose<double>>& poses,
                  Solution& solution) {
    int behind = 0;
    solution.in_front = 0;
    for (std::size_t f = 0; f < solution.features.size(); ++f) {
        SpaceFeature& feature = solution.features[f];
        if (!feature.point) continue;
        bool everywhere = true;
        for (std::size_t v = 0; v < poses.size(); ++v) {
            const auto& seen = images.observation[f][v].point;
            if (!seen) continue;
            const bool front = is_in_front(feature.point->real(), poses[v], *seen);
            feature.in_front[v] = front;
            everywhere = everywhere && front;
            behind += front ? -1 : 1;
        }
        solution.in_front += everywhere;
    }
    return behind;
}

/// How far, in pixels, what is seen reaches from the origin of the images.
double reach(const SeenImages& images) {
    double largest = 0;
    for (const FeatureSightings& sightings : images.observation)
        for (std::size_t v = 0; v < sightings.size(); ++v) {
            const Eigen::Matrix3d& K = images.calibration[v];
            if (const auto& point = sightings[v].point)
                largest = std::max(largest, (K * *point).eval().hnormalized().norm());
            for (const auto& line : sightings[v].lines) {
                if (!line) continue;
                const Eigen::Vector3d in_pixels = K.inverse().transpose() * *line;
                largest = std::max(largest, std::abs(in_pixels[2]) / in_pixels.head<2>().norm());
            }
        }
    return largest;
}

} // namespace

Solution real_solution(const SeenImages& images, std::vector<Pose<double>> poses) {
    Solution solution = reconstruct(images, poses);
    if (mark_in_front(images, poses, solution) > 0) {
        for (Pose<double>& pose : poses)
            pose.t = -pose.t;
        reflect(solution);
        mark_in_front(images, poses, solution);
    }
    solution.real = true;
    return solution;
}

bool explains(const Solution& solution, const SeenImages& images) {
    constexpr double most = 0.01;
    return solution.residual <= most * reach(images);
}

Solution complex_solution(const SeenImages& images, const std::vector<ComplexPose>& poses) {
    return reconstruct(images, poses);
}

} // namespace plprove
