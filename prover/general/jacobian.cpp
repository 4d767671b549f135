#include "prover/general/jacobian.h"

#include "prover/general/moving.h"
#include "prover/geometry/quaternion.h"

namespace plprove::general {

namespace {

/// A line in motion: a point and a direction.
struct MovingLine {
    Moving point;
    Moving direction;
};

struct Scene {
    std::vector<Moving> points;
    std::vector<MovingLine> lines;
};

/// Builds the scene in the order of its unknowns.
class SceneBuilder {
public:
    SceneBuilder(const Problem& problem, const Instance& instance)
        : problem_(problem), instance_(instance), unknowns_(dimension_in_space(problem)) {}

    Scene build() {
        for (int point = 0; point < static_cast<int>(problem_.points.size()); ++point)
            scene_.points.push_back(next_point(point));
        for (const Line& line : problem_.lines)
            scene_.lines.push_back(next_line(line));
        return std::move(scene_);
    }

private:
    Residue next_coordinate() { return residue(instance_.scene[next_coordinate_++]); }

    /// A vector from the file. Its first `moving` coordinates are unknowns.
    Moving next_vector(std::size_t moving) {
        Moving vector(unknowns_);
        for (std::size_t i = 0; i < 3; ++i)
            vector.value[i] = next_coordinate();
        for (std::size_t i = 0; i < moving; ++i)
            vector.derivative[next_unknown_++][i] = 1;
        return vector;
    }

    const Moving& point(int number) const {
        return scene_.points[static_cast<std::size_t>(number)];
    }

    Moving next_point(int number) {
        const std::optional<int> on = carrier(problem_, number);
        if (!on) return next_vector(3);
        const std::vector<int>& base = problem_.lines[static_cast<std::size_t>(*on)].points;
        const Moving direction = difference(point(base[1]), point(base[0]));
        Moving result = plus_multiple(point(base[0]), next_coordinate(), direction);
        result.derivative[next_unknown_++] = direction.value;
        return result;
    }

    MovingLine next_line(const Line& line) {
        if (line.points.empty()) {
            Moving start = next_vector(2);
            return {std::move(start), next_vector(2)};
        }
        const Moving& start = point(line.points[0]);
        if (line.points.size() == 1) return {start, next_vector(2)};
        return {start, difference(point(line.points[1]), start)};
    }

    const Problem& problem_;
    const Instance& instance_;
    int unknowns_;
    std::size_t next_coordinate_ = 0;
    std::size_t next_unknown_ = 0;
    Scene scene_;
};

/// The matrix of section 2 for a quaternion, and the translation.
CameraMatrix calibrated_matrix(const std::vector<std::int64_t>& numbers) {
    const auto rotation =
        quaternion_matrix(std::array{numbers[0], numbers[1], numbers[2], numbers[3]});
    CameraMatrix matrix{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j)
            matrix[i][j] = residue(rotation[i][j]);
        matrix[i][3] = residue(numbers[4 + i]);
    }
    return matrix;
}

/// Turns by [w]x R, and translations; the first coordinate of the second camera's translation is
/// kept.
MovingCamera calibrated_camera(int view, const std::vector<std::int64_t>& numbers) {
    MovingCamera camera{calibrated_matrix(numbers), {}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Vector w{};
        w[axis] = 1;
        CameraMatrix turn{};
        for (std::size_t j = 0; j < 3; ++j) {
            const Vector column{camera.matrix[0][j], camera.matrix[1][j], camera.matrix[2][j]};
            const Vector turned = cross(w, column);
            for (std::size_t i = 0; i < 3; ++i)
                turn[i][j] = turned[i];
        }
        camera.derivative.push_back(turn);
    }
    for (std::size_t i = view == 1 ? 1 : 0; i < 3; ++i) {
        CameraMatrix shift{};
        shift[i][3] = 1;
        camera.derivative.push_back(shift);
    }
    return camera;
}

/// All entries move, but the first five of camera 2 and the first of the others.
MovingCamera projective_camera(int view, const std::vector<std::int64_t>& numbers) {
    MovingCamera camera;
    for (std::size_t i = 0; i < 12; ++i)
        camera.matrix[i / 4][i % 4] = residue(numbers[i]);
    for (std::size_t i = view == 1 ? 5 : 1; i < 12; ++i) {
        CameraMatrix entry{};
        entry[i / 4][i % 4] = 1;
        camera.derivative.push_back(entry);
    }
    return camera;
}

MovingCamera camera_of_view(CameraModel model, int view, const Instance& instance) {
    if (view == 0) {
        MovingCamera first;
        for (std::size_t i = 0; i < 3; ++i)
            first.matrix[i][i] = 1;
        return first;
    }
    const std::vector<std::int64_t>& numbers = instance.cameras[static_cast<std::size_t>(view) - 1];
    return model == CameraModel::calibrated ? calibrated_camera(view, numbers)
                                            : projective_camera(view, numbers);
}

/// The image of a point (weight 1) or of a direction (weight 0).
Vector image(const CameraMatrix& camera, const Vector& x, Residue weight) {
    Vector result{};
    for (std::size_t i = 0; i < 3; ++i)
        result[i] =
            plus(dot({camera[i][0], camera[i][1], camera[i][2]}, x), times(weight, camera[i][3]));
    return result;
}

/// Writes the rows of one view after another.
class RowWriter {
public:
    RowWriter(ResidueMatrix& matrix, int scene_unknowns)
        : matrix_(matrix), next_column_(scene_unknowns) {}

    void write_view(const Problem& problem, const Scene& scene, int view, MovingCamera camera) {
        camera_ = std::move(camera);
        for (int point = 0; point < static_cast<int>(problem.points.size()); ++point)
            if (contains(problem.points[static_cast<std::size_t>(point)], view))
                write_point(scene.points[static_cast<std::size_t>(point)],
                            is_on_known_line(problem, point, view));
        for (std::size_t i = 0; i < problem.lines.size(); ++i)
            if (contains(problem.lines[i].seen, view))
                write_line(scene.lines[i], seen_points(problem, problem.lines[i], view).size());
        next_column_ += static_cast<int>(camera_.derivative.size());
    }

private:
    /// Whether the view sees a line through the point, and on it two earlier points.
    static bool is_on_known_line(const Problem& problem, int point, int view) {
        for (const int number : lines_through(problem, point)) {
            const Line& line = problem.lines[static_cast<std::size_t>(number)];
            const std::vector<int> seen = seen_points(problem, line, view);
            if (seen.size() >= 3 && seen[1] < point) return true;
        }
        return false;
    }

    void write_point(const Moving& point, bool on_known_line) {
        const Vector x = image(camera_.matrix, point.value, 1);
        write_row({0, x[2], minus(0, x[1])}, point, 1);
        if (!on_known_line) write_row({minus(0, x[2]), 0, x[0]}, point, 1);
    }

    void write_line(const MovingLine& line, std::size_t seen_points) {
        if (seen_points >= 2) return;
        const Vector x = image(camera_.matrix, line.point.value, 1);
        const Vector e = image(camera_.matrix, line.direction.value, 0);
        const Vector l = cross(x, e);
        if (seen_points == 0) write_row(l, line.point, 1);
        write_row(l, line.direction, 0);
    }

    /// l . d(P (X, weight)), where P and X move.
    void write_row(const Vector& l, const Moving& x, Residue weight) {
        const CameraMatrix& p = camera_.matrix;
        Vector pulled{};
        for (std::size_t j = 0; j < 3; ++j)
            pulled[j] = dot(l, {p[0][j], p[1][j], p[2][j]});
        for (std::size_t k = 0; k < x.derivative.size(); ++k)
            matrix_.at(next_row_, static_cast<int>(k)) = dot(pulled, x.derivative[k]);
        for (std::size_t k = 0; k < camera_.derivative.size(); ++k)
            matrix_.at(next_row_, next_column_ + static_cast<int>(k)) =
                dot(l, image(camera_.derivative[k], x.value, weight));
        ++next_row_;
    }

    ResidueMatrix& matrix_;
    MovingCamera camera_;
    int next_row_ = 0;
    int next_column_;
};

} // namespace

int scene_coordinates(const Problem& problem) {
    int count = 0;
    for (int point = 0; point < static_cast<int>(problem.points.size()); ++point)
        count += carrier(problem, point) ? 1 : 3;
    for (const Line& line : problem.lines)
        count += 3 * own_points(line);
    return count;
}

ResidueMatrix jacobian(const Problem& problem, const Instance& instance) {
    const int scene_unknowns = dimension_in_space(problem);
    ResidueMatrix matrix(dimension_in_views(problem),
                         scene_unknowns + camera_dimension(problem.model, problem.views));
    const Scene scene = SceneBuilder(problem, instance).build();
    RowWriter rows(matrix, scene_unknowns);
    for (int view = 0; view < problem.views; ++view)
        rows.write_view(problem, scene, view, camera_of_view(problem.model, view, instance));
    return matrix;
}

} // namespace plprove::general
