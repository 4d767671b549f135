#include "prover/estimator/refinement.h"

#include <Eigen/Geometry>
#include <array>
#include <ceres/ceres.h>
#include <ceres/rotation.h>
#include <cmath>
#include <deque>

namespace plprove {

namespace {

template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;

template <class T>
Vector3<T> turned(const T* rotation_vector, const Vector3<T>& x) {
    Vector3<T> result;
    ceres::AngleAxisRotatePoint(rotation_vector, x.data(), result.data());
    return result;
}

/// A camera that is to be found: exp(turn) base, and t.
struct MovingCamera {
    Eigen::Matrix3d base;
    std::array<double, 3> turn{};
    std::array<double, 3> t{};

    template <class T>
    Vector3<T> rotated(const T* turn_now, const Vector3<T>& x) const {
        return turned<T>(turn_now, base.cast<T>() * x);
    }
    /// Takes the turn into the base.
    void settle() {
        Eigen::Matrix3d rotation;
        ceres::AngleAxisToRotationMatrix(turn.data(), rotation.data());
        base = rotation * base;
        turn.fill(0);
    }
};

/// The distance of the image of a point from where it was seen.
struct PointError {
    const MovingCamera* camera;
    PinholeIntrinsics intrinsics;
    Eigen::Vector2d seen;

    template <class T>
    bool operator()(const T* turn, const T* t, const T* point, T* error) const {
        const Vector3<T> x = camera->rotated<T>(turn, Eigen::Map<const Vector3<T>>(point)) +
                             Eigen::Map<const Vector3<T>>(t);
        error[0] = intrinsics.fx * (x.x() / x.z() - seen.x());
        error[1] = intrinsics.fy * (x.y() / x.z() - seen.y());
        return true;
    }
};

/// The distances of the ends of a segment from an image line.
struct EndDistances {
    PinholeIntrinsics intrinsics;
    Segment seen;

    template <class T>
    void write(const Vector3<T>& line, T* error) const {
        const T a = line.x() / intrinsics.fx, b = line.y() / intrinsics.fy;
        const T size = sqrt(a * a + b * b);
        error[0] = line.dot(seen.begin.homogeneous().cast<T>()) / size;
        error[1] = line.dot(seen.end.homogeneous().cast<T>()) / size;
    }
};

/// A line that is to be found, in the orthonormal representation of A. Bartoli and P. Sturm (CVIU
/// 2005): (cos a) e1 and (sin a) e2 are direction and moment up to a factor, e1 and e2 the first
/// two columns of exp(change) base. The change of a is the fourth entry of `change`.
struct MovingLine {
    Eigen::Matrix3d base;
    double angle = 0;
    std::array<double, 4> change{};

    explicit MovingLine(const PluckerLine& line) {
        const double size = line.moment.norm();
        base.col(0) = line.direction;
        base.col(1) = size > 0 ? Eigen::Vector3d(line.moment / size)
                               : Eigen::Vector3d(line.direction.unitOrthogonal());
        base.col(2) = base.col(0).cross(base.col(1));
        angle = std::atan2(size, 1.0);
    }
};

struct LineError {
    const MovingCamera* camera;
    const MovingLine* line;
    EndDistances distances;

    template <class T>
    bool operator()(const T* turn, const T* t, const T* change, T* error) const {
        const T angle = line->angle + change[3];
        const Vector3<T> first = line->base.col(0).cast<T>(), second = line->base.col(1).cast<T>();
        const Vector3<T> direction =
            camera->rotated<T>(turn, turned<T>(change, first)) * cos(angle);
        const Vector3<T> moment = camera->rotated<T>(turn, turned<T>(change, second)) * sin(angle);
        distances.write<T>(moment + Eigen::Map<const Vector3<T>>(t).cross(direction), error);
        return true;
    }
};

/// The direction of a line through a point: it moves in the plane of two vectors.
struct MovingDirection {
    Eigen::Vector3d base, along, across;
    std::array<double, 2> change{};

    explicit MovingDirection(const Eigen::Vector3d& direction)
        : base(direction), along(direction.unitOrthogonal()), across(direction.cross(along)) {}
};

struct PinError {
    const MovingCamera* camera;
    const MovingDirection* direction;
    EndDistances distances;

    template <class T>
    bool operator()(const T* turn, const T* t, const T* point, const T* change, T* error) const {
        const Vector3<T> moved = direction->base.cast<T>() +
                                 direction->along.cast<T>() * change[0] +
                                 direction->across.cast<T>() * change[1];
        const Vector3<T> x = camera->rotated<T>(turn, Eigen::Map<const Vector3<T>>(point)) +
                             Eigen::Map<const Vector3<T>>(t);
        distances.write<T>(x.cross(camera->rotated<T>(turn, moved)), error);
        return true;
    }
};

/// The adjustment: what moves, and the problem of Ceres that refers to it.
class Adjustment {
public:
    Adjustment(const Poses& cameras, const Matches& matches, double scale)
        : matches_(matches), problem_(owning_nothing_of_the_loss()), loss_(scale) {
        for (const Pose<double>& pose : cameras) {
            MovingCamera& camera = cameras_.emplace_back(MovingCamera{pose.R});
            Eigen::Map<Eigen::Vector3d>(camera.t.data()) = pose.t;
            problem_.AddParameterBlock(camera.turn.data(), 3);
            problem_.AddParameterBlock(camera.t.data(), 3);
        }
        unknowns_ += 6 * static_cast<int>(cameras_.size() - 1);
        problem_.SetParameterBlockConstant(cameras_[0].turn.data());
        problem_.SetParameterBlockConstant(cameras_[0].t.data());
        problem_.SetManifold(cameras_[1].t.data(), new ceres::SphereManifold<3>);
    }

    void add(const Inliers& inliers, const Poses& cameras) {
        points_.resize(matches_.points.size());
        for (const std::size_t p : inliers.points)
            if (const auto point = space_point(matches_.points[p], cameras)) add_point(p, *point);
        std::vector<std::array<double, 3>*> point_of(matches_.lines.size());
        for (const std::size_t p : inliers.points)
            for (const std::size_t l : matches_.lines_through[p])
                if (!point_of[l]) point_of[l] = points_[p];
        for (const std::size_t l : inliers.lines) {
            const auto line = space_line(matches_.lines[l], cameras);
            if (!line) continue;
            if (point_of[l])
                add_pin(l, point_of[l], line->direction);
            else
                add_line(l, *line);
        }
    }

    bool fixes_the_cameras() const { return equations_ >= unknowns_; }

    bool solve(int iterations) {
        ceres::Solver::Options options;
        options.max_num_iterations = iterations;
        options.linear_solver_type = ceres::SPARSE_SCHUR;
        options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
        options.logging_type = ceres::SILENT;
        ceres::Solver::Summary summary;
        ceres::Solve(options, &problem_, &summary);
        for (MovingCamera& camera : cameras_)
            camera.settle();
        return summary.IsSolutionUsable();
    }

    Poses cameras() const {
        Poses result;
        for (const MovingCamera& camera : cameras_)
            result.push_back({camera.base, Eigen::Map<const Eigen::Vector3d>(camera.t.data())});
        return result;
    }

    /// The root of the mean of the squares of all distances.
    double rms() {
        ceres::Problem::EvaluateOptions options;
        options.apply_loss_function = false;
        double cost = 0; // half the sum of squares
        problem_.Evaluate(options, &cost, nullptr, nullptr, nullptr);
        return std::sqrt(2 * cost / std::max(equations_, 1));
    }

    Eigen::MatrixXd covariance() {
        std::vector<const double*> blocks;
        for (std::size_t v = 1; v < cameras_.size(); ++v) {
            blocks.push_back(cameras_[v].turn.data());
            blocks.push_back(cameras_[v].t.data());
        }
        ceres::Covariance::Options options;
        options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
        ceres::Covariance covariance(options);
        const auto size = static_cast<Eigen::Index>(3 * blocks.size());
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> result(size, size);
        if (!covariance.Compute(blocks, &problem_) ||
            !covariance.GetCovarianceMatrix(blocks, result.data()))
            return {};
        // The variance of one distance, estimated from what is left of all.
        const double free = std::max(equations_ - unknowns_, 1);
        return result * (rms() * rms() * equations_ / free);
    }

private:
    static ceres::Problem::Options owning_nothing_of_the_loss() {
        ceres::Problem::Options options;
        options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
        return options;
    }

    void add_point(std::size_t index, const Eigen::Vector3d& start) {
        std::array<double, 3>* const point = &point_blocks_.emplace_back();
        points_[index] = point;
        Eigen::Map<Eigen::Vector3d>(point->data()) = start;
        unknowns_ += 3;
        for (std::size_t v = 0; v < cameras_.size(); ++v) {
            const auto& seen = matches_.points[index][v];
            if (!seen) continue;
            add<PointError, 3>({&cameras_[v], matches_.intrinsics[v], *seen}, v, point->data());
        }
    }

    void add_line(std::size_t index, const PluckerLine& start) {
        MovingLine& line = lines_.emplace_back(start);
        unknowns_ += 4;
        for (std::size_t v = 0; v < cameras_.size(); ++v) {
            const auto& seen = matches_.lines[index][v];
            if (!seen) continue;
            add<LineError, 4>({&cameras_[v], &line, {matches_.intrinsics[v], *seen}}, v,
                              line.change.data());
        }
    }

    void add_pin(std::size_t index, std::array<double, 3>* point, const Eigen::Vector3d& start) {
        MovingDirection& direction = directions_.emplace_back(start);
        unknowns_ += 2;
        for (std::size_t v = 0; v < cameras_.size(); ++v) {
            const auto& seen = matches_.lines[index][v];
            if (!seen) continue;
            add<PinError, 3, 2>({&cameras_[v], &direction, {matches_.intrinsics[v], *seen}}, v,
                                point->data(), direction.change.data());
        }
    }

    template <class Error, int... sizes, class... Blocks>
    void add(const Error& error, std::size_t view, Blocks... blocks) {
        problem_.AddResidualBlock(
            new ceres::AutoDiffCostFunction<Error, 2, 3, 3, sizes...>(new Error(error)), &loss_,
            cameras_[view].turn.data(), cameras_[view].t.data(), blocks...);
        equations_ += 2;
    }

    const Matches& matches_;
    // Ceres keeps addresses: these do not move.
    std::deque<MovingCamera> cameras_;
    std::deque<std::array<double, 3>> point_blocks_;
    std::deque<MovingLine> lines_;
    std::deque<MovingDirection> directions_;
    std::vector<std::array<double, 3>*> points_; ///< by index; null where one does not count
    ceres::Problem problem_;
    ceres::CauchyLoss loss_;
    int equations_ = 0;
    int unknowns_ = -1; ///< the translation of camera 2 has length 1
};

} // namespace

std::optional<Refined> refined(const Poses& cameras, const Matches& matches, const Inliers& inliers,
                               const RefinementOptions& options) {
    Adjustment adjustment(cameras, matches, options.scale);
    adjustment.add(inliers, cameras);
    if (!adjustment.fixes_the_cameras() || !adjustment.solve(options.iterations))
        return std::nullopt;
    Refined result{adjustment.cameras(), {}, adjustment.rms()};
    if (options.covariance) result.covariance = adjustment.covariance();
    return result;
}

} // namespace plprove
