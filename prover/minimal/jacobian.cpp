#include "prover/minimal/jacobian.h"

namespace plprove {

namespace {

template <class T>
using Vector3Of = std::array<T, 3>;

template <class T>
T dot(const Vector3Of<T>& a, const Vector3Of<T>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class T>
Vector3Of<T> cross(const Vector3Of<T>& a, const Vector3Of<T>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A vector of space and its derivatives by the unknowns of the scene.
template <class T>
struct Moving {
    Vector3Of<T> value{};
    std::vector<Vector3Of<T>> derivative;
};

/// a + s b, where s does not move.
template <class T>
Moving<T> plus_multiple(const Moving<T>& a, const T& s, const Moving<T>& b) {
    Moving<T> sum = a;
    for (std::size_t i = 0; i < 3; ++i) {
        sum.value[i] = sum.value[i] + s * b.value[i];
        for (std::size_t k = 0; k < sum.derivative.size(); ++k)
            sum.derivative[k][i] = sum.derivative[k][i] + s * b.derivative[k][i];
    }
    return sum;
}

/// A line in motion: a point and a direction.
template <class T>
struct MovingLine {
    Moving<T> point;
    Moving<T> direction;
};

template <class T>
struct Scene {
    std::vector<Moving<T>> points;
    std::vector<MovingLine<T>> lines;
};

/// Builds the scene in the order of its unknowns.
template <class T>
class SceneBuilder {
public:
    SceneBuilder(const Problem& problem, const Instance& instance)
        : problem_(problem), instance_(instance),
          unknowns_(static_cast<std::size_t>(dimension_in_space(problem))) {}

    Scene<T> build() {
        for (int point = 0; point < static_cast<int>(problem_.points.size()); ++point)
            scene_.points.push_back(next_point(point));
        for (const Line& line : problem_.lines)
            scene_.lines.push_back(next_line(line));
        return std::move(scene_);
    }

private:
    T next_coordinate() { return T(instance_.scene[next_coordinate_++]); }

    /// A vector from the file. Its first coordinates, `moving` of them, are unknowns.
    Moving<T> next_vector(std::size_t moving) {
        Moving<T> vector{{}, std::vector<Vector3Of<T>>(unknowns_)};
        for (T& coordinate : vector.value)
            coordinate = next_coordinate();
        for (std::size_t i = 0; i < moving; ++i)
            vector.derivative[next_unknown_++][i] = T(1);
        return vector;
    }

    const Moving<T>& point(int number) const {
        return scene_.points[static_cast<std::size_t>(number)];
    }

    Moving<T> next_point(int number) {
        const std::optional<int> on = carrier(problem_, number);
        if (!on) return next_vector(3);
        const std::vector<int>& base = problem_.lines[static_cast<std::size_t>(*on)].points;
        const Moving<T> direction = plus_multiple(point(base[1]), T(-1), point(base[0]));
        Moving<T> result = plus_multiple(point(base[0]), next_coordinate(), direction);
        result.derivative[next_unknown_++] = direction.value;
        return result;
    }

    MovingLine<T> next_line(const Line& line) {
        if (line.points.empty()) {
            Moving<T> start = next_vector(2);
            return {std::move(start), next_vector(2)};
        }
        const Moving<T>& start = point(line.points[0]);
        if (line.points.size() == 1) return {start, next_vector(2)};
        return {start, plus_multiple(point(line.points[1]), T(-1), start)};
    }

    const Problem& problem_;
    const Instance& instance_;
    std::size_t unknowns_;
    std::size_t next_coordinate_ = 0;
    std::size_t next_unknown_ = 0;
    Scene<T> scene_;
};

template <class T>
MovingCamera<T> camera_of_view(const Problem& problem, int view, const Instance& instance) {
    if (view > 0)
        return place<T>(*problem.cameras, instance.cameras[static_cast<std::size_t>(view - 1)],
                        instance.shared, view == 1);
    MovingCamera<T> first;
    for (std::size_t i = 0; i < 3; ++i)
        first.matrix[i][i] = T(1);
    return first;
}

/// The image of a point (weight 1) or of a direction (weight 0).
template <class T>
Vector3Of<T> image(const CameraMatrix<T>& camera, const Vector3Of<T>& x, int weight) {
    Vector3Of<T> result{};
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = dot<T>({camera[i][0], camera[i][1], camera[i][2]}, x);
        if (weight != 0) result[i] = result[i] + camera[i][3];
    }
    return result;
}

/// Writes the rows of one view after another.
template <class T>
class RowWriter {
public:
    RowWriter(Matrix<T>& matrix, int scene_unknowns, int shared)
        : matrix_(matrix), first_shared_(scene_unknowns), next_column_(scene_unknowns + shared) {}

    void write_view(const Problem& problem, const Scene<T>& scene, int view,
                    MovingCamera<T> camera) {
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

    void write_point(const Moving<T>& point, bool on_known_line) {
        const Vector3Of<T> x = image(camera_.matrix, point.value, 1);
        write_row({T{}, x[2], T{} - x[1]}, point, 1);
        if (!on_known_line) write_row({T{} - x[2], T{}, x[0]}, point, 1);
    }

    void write_line(const MovingLine<T>& line, std::size_t seen_points) {
        if (seen_points >= 2) return;
        const Vector3Of<T> l = cross(image(camera_.matrix, line.point.value, 1),
                                     image(camera_.matrix, line.direction.value, 0));
        if (seen_points == 0) write_row(l, line.point, 1);
        write_row(l, line.direction, 0);
    }

    /// l . d(P (X, weight)), where P and X move.
    void write_row(const Vector3Of<T>& l, const Moving<T>& x, int weight) {
        const CameraMatrix<T>& p = camera_.matrix;
        Vector3Of<T> pulled{};
        for (std::size_t j = 0; j < 3; ++j)
            pulled[j] = dot<T>(l, {p[0][j], p[1][j], p[2][j]});
        for (std::size_t k = 0; k < x.derivative.size(); ++k)
            matrix_.at(next_row_, static_cast<int>(k)) = dot(pulled, x.derivative[k]);
        write_derivatives(camera_.by_shared, first_shared_, l, x.value, weight);
        write_derivatives(camera_.derivative, next_column_, l, x.value, weight);
        ++next_row_;
    }

    /// l . dP (X, weight) for each of these dP, from a column on.
    void write_derivatives(const std::vector<CameraMatrix<T>>& derivatives, int column,
                           const Vector3Of<T>& l, const Vector3Of<T>& x, int weight) {
        for (const CameraMatrix<T>& derivative : derivatives)
            matrix_.at(next_row_, column++) = dot(l, image(derivative, x, weight));
    }

    Matrix<T>& matrix_;
    MovingCamera<T> camera_;
    int next_row_ = 0;
    int first_shared_;
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

template <class T>
Matrix<T> jacobian(const Problem& problem, const Instance& instance) {
    const int scene_unknowns = dimension_in_space(problem);
    Matrix<T> matrix(dimension_in_views(problem),
                     scene_unknowns + problem.cameras->dimension(problem.views));
    const Scene<T> scene = SceneBuilder<T>(problem, instance).build();
    RowWriter<T> rows(matrix, scene_unknowns, problem.cameras->shared);
    for (int view = 0; view < problem.views; ++view)
        rows.write_view(problem, scene, view, camera_of_view<T>(problem, view, instance));
    return matrix;
}

template Matrix<std::int64_t> jacobian(const Problem&, const Instance&);
template Matrix<Modular> jacobian(const Problem&, const Instance&);

ResidueMatrix jacobian_modulo_q(const Problem& problem, const Instance& instance) {
    const Matrix<Modular> matrix = jacobian<Modular>(problem, instance);
    ResidueMatrix result(matrix.rows, matrix.columns);
    for (int i = 0; i < matrix.rows; ++i)
        for (int j = 0; j < matrix.columns; ++j)
            result.at(i, j) = matrix.at(i, j).value();
    return result;
}

} // namespace plprove
