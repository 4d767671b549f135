#include "checker/minimal/jacobian.h"

namespace checker {
template <class T> using Vector = Vector3<Dual<T>>;

/// A line through the point with this direction.
template <class T> struct PlacedLine {
    Vector<T> point;
    Vector<T> direction;
};

template <class T> struct Scene {
    std::vector<Vector<T>> points{};
    std::vector<PlacedLine<T>> lines{};
};

// The elements of a list in braces are evaluated in order, so these take numbers in order.
template <class T> static Vector<T> free_point(Source<T>& source) {
    return {source.unknown(), source.unknown(), source.unknown()};
}

template <class T> static Vector<T> with_fixed_third(Source<T>& source) {
    return {source.unknown(), source.unknown(), source.fixed()};
}

std::size_t scene_size(const Problem& problem) {
    const auto [free, carried, of_lines] = scene_parts(problem);
    return 3 * free + carried + 3 * of_lines;
}

template <class T>
static Vector<T> place_point(const Problem& problem, std::size_t p, Source<T>& source,
                             const std::vector<Vector<T>>& before) {
    const std::optional<std::size_t> on = carrier(problem, p);
    if (!on) return free_point(source);
    const Vector<T>& a = before[problem.lines[*on].points[0]];
    const Vector<T>& b = before[problem.lines[*on].points[1]];
    return plus(a, times(source.unknown(), minus(b, a)));
}

template <class T> static Scene<T> place_scene(const Problem& problem, Source<T>& source) {
    Scene<T> scene;
    std::vector<Vector<T>>& points = scene.points;
    for (std::size_t p = 0; p < problem.points.size(); ++p)
        points.push_back(place_point(problem, p, source, points));
    for (const Line& line : problem.lines) {
        const std::size_t count = line.points.size();
        const Vector<T> a = count == 0 ? with_fixed_third(source) : points[line.points[0]];
        const Vector<T> e = count < 2 ? with_fixed_third(source) : minus(points[line.points[1]], a);
        scene.lines.push_back({a, e});
    }
    return scene;
}

/// The camera's matrix times (X, w).
template <class T>
static Vector<T> image(const CameraMatrix<Dual<T>>& camera, const Vector<T>& x, unsigned w) {
    Vector<T> sum = times(constant<T>(T{w}), camera[3]);
    for (std::size_t i = 0; i < 3; ++i)
        sum = plus(sum, times(x[i], camera[i]));
    return sum;
}

template <class T> static Vector3<T> values(const Vector<T>& x) {
    return {x[0].value, x[1].value, x[2].value};
}

/// The row l·dx.
template <class T> static std::vector<T> row(const Vector3<T>& l, const Vector<T>& x) {
    const Vector<T> fixed{constant<T>(l[0]), constant<T>(l[1]), constant<T>(l[2])};
    return dot(fixed, x).change;
}

/// Whether the view sees the point on a line through two earlier points that it sees, too.
static bool is_dependent(const Problem& problem, std::size_t point, unsigned view) {
    for (const std::size_t line : problem.points[point].lines)
        if (has_view(problem.lines[line].seen_by, view) &&
            earlier_points(problem, line, point, view) >= 2)
            return true;
    return false;
}

template <class T>
static void add_rows_of_view(Jacobian<T>& j, const Problem& problem, const Scene<T>& scene,
                             const CameraMatrix<Dual<T>>& camera, unsigned view) {
    const std::size_t points = problem.points.size();
    for (std::size_t p = 0; p < points; ++p) {
        if (!has_view(problem.points[p].seen_by, view)) continue;
        const Vector<T> x = image<T>(camera, scene.points[p], 1);
        const Vector3<T> v = values<T>(x);
        j.rows.push_back(row<T>({T{}, v[2], -v[1]}, x));
        if (!is_dependent(problem, p, view)) j.rows.push_back(row<T>({-v[2], T{}, v[0]}, x));
    }
    for (std::size_t n = 0; n < problem.lines.size(); ++n) {
        if (!has_view(problem.lines[n].seen_by, view)) continue;
        const std::size_t seen_points = earlier_points(problem, n, points, view);
        if (seen_points > 1) continue;
        const Vector<T> a = image<T>(camera, scene.lines[n].point, 1);
        const Vector<T> e = image<T>(camera, scene.lines[n].direction, 0);
        const Vector3<T> l = cross(values<T>(a), values<T>(e));
        if (seen_points == 0) j.rows.push_back(row<T>(l, a));
        j.rows.push_back(row<T>(l, e));
    }
}

template <class T>
static std::vector<Dual<T>> place_shared(const Placement& placement, Source<T>& source) {
    source.read(placement.shared);
    std::vector<Dual<T>> shared;
    while (shared.size() < placement.shared.size())
        shared.push_back(source.unknown());
    return shared;
}

template <class T> Jacobian<T> jacobian(const Problem& problem, const Placement& placement) {
    Jacobian<T> j;
    Source<T> source;
    source.read(placement.scene);
    const Scene<T> scene = place_scene(problem, source);
    j.own = source.unknowns();
    const std::vector<Dual<T>> shared = place_shared(placement, source);
    add_rows_of_view(j, problem, scene, first_camera<T>(), 0);
    for (unsigned view = 1; view <= placement.cameras.size(); ++view) {
        source.read(placement.cameras[view - 1]);
        const CameraMatrix<Dual<T>> camera =
            place_camera(*problem.cameras, source, shared, view == 1);
        add_rows_of_view(j, problem, scene, camera, view);
    }
    for (std::vector<T>& row : j.rows)
        row.resize(source.unknowns());
    return j;
}

template Jacobian<mpz_class> jacobian(const Problem&, const Placement&);
template Jacobian<Residue> jacobian(const Problem&, const Placement&);

static void require_images(const Problem& problem, const Scene<mpz_class>& scene,
                           const CameraMatrix<Dual<mpz_class>>& camera, unsigned view) {
    const auto seen = [&](const auto& thing) { return has_view(thing.seen_by, view); };
    for (std::size_t p = 0; p < problem.points.size(); ++p)
        if (seen(problem.points[p]) && image(camera, scene.points[p], 1)[2].value == 0)
            throw Refused("an image of the point has third coordinate 0");
    for (std::size_t n = 0; n < problem.lines.size(); ++n) {
        const PlacedLine<mpz_class>& line = scene.lines[n];
        if (line.direction[2].value == 0) throw Refused("a direction has third coordinate 0");
        if (!seen(problem.lines[n])) continue;
        const IntegerVector a = values(image(camera, line.point, 1));
        const IntegerVector e = values(image(camera, line.direction, 0));
        if (cross(a, e) == IntegerVector{}) throw Refused("the image of a line is zero");
    }
}

void require_cameras(const CameraModel& model, const std::vector<Numbers>& cameras) {
    for (const Numbers& camera : cameras) {
        const std::string_view objection = model.objection(camera, &camera == &cameras[0]);
        if (!objection.empty()) throw Refused(objection);
    }
}

void require_section_2(const Problem& problem, const Placement& placement) {
    require_cameras(*problem.cameras, placement.cameras);
    Source<mpz_class> source(true);
    source.read(placement.scene);
    const Scene<mpz_class> scene = place_scene(problem, source);
    require_images(problem, scene, first_camera<mpz_class>(), 0);
    for (unsigned view = 1; view <= placement.cameras.size(); ++view) {
        source.read(placement.cameras[view - 1]);
        require_images(problem, scene, place_camera(*problem.cameras, source, {}, view == 1), view);
    }
}
} // namespace checker
