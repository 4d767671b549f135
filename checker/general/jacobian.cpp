#include "checker/general/jacobian.h"

#include "checker/general/dual.h"

#include <span>

namespace checker::general {
using Vector = Vector3<Dual>;

/// The columns of a camera matrix: it takes X to X_1 c_1 + X_2 c_2 + X_3 c_3 + c_4.
using Camera = std::array<Vector, 4>;

/// A line through the point with this direction.
struct PlacedLine {
    Vector point;
    Vector direction;
};

struct Scene {
    std::vector<Vector> points{};
    std::vector<PlacedLine> lines{};
};

/// The numbers of a record, in order. The unknowns, the columns of J, are numbered as they come.
class Source {
public:
    void read(std::span<const int> numbers) { numbers_ = numbers; }

    Dual fixed() {
        const int number = numbers_.front();
        numbers_ = numbers_.subspan(1);
        const auto size = static_cast<std::uint64_t>(std::abs(number));
        return constant(number < 0 ? -Residue{size} : Residue{size});
    }

    Dual unknown() { return varied(fixed().value); }

    /// The next unknown, with this value.
    Dual varied(Residue value) {
        Dual result{value, std::vector<Residue>(unknowns_ + 1)};
        result.change[unknowns_++] = {1};
        return result;
    }

    std::size_t unknowns() const { return unknowns_; }

private:
    std::span<const int> numbers_{};
    std::size_t unknowns_ = 0;
};

// The elements of a list in braces are evaluated in order, so these take numbers in order.
static Vector free_point(Source& source) {
    return {source.unknown(), source.unknown(), source.unknown()};
}

static Vector with_fixed_third(Source& source) {
    return {source.unknown(), source.unknown(), source.fixed()};
}

std::size_t scene_size(const Problem& problem) {
    std::size_t size = 0;
    for (std::size_t p = 0; p < problem.points.size(); ++p)
        size += carrier(problem, p) ? 1 : 3;
    for (const Line& line : problem.lines)
        size += 3 * own_points(line);
    return size;
}

static Scene place_scene(const Problem& problem, Source& source) {
    Scene scene;
    std::vector<Vector>& points = scene.points;
    for (std::size_t p = 0; p < problem.points.size(); ++p) {
        const std::optional<std::size_t> on = carrier(problem, p);
        if (!on) {
            points.push_back(free_point(source));
            continue;
        }
        const Vector& a = points[problem.lines[*on].points[0]];
        const Vector& b = points[problem.lines[*on].points[1]];
        points.push_back(plus(a, times(source.unknown(), minus(b, a))));
    }
    for (const Line& line : problem.lines) {
        const std::size_t count = line.points.size();
        const Vector a = count == 0 ? with_fixed_third(source) : points[line.points[0]];
        const Vector e = count < 2 ? with_fixed_third(source) : minus(points[line.points[1]], a);
        scene.lines.push_back({a, e});
    }
    return scene;
}

static Camera first_camera() {
    Camera camera;
    for (std::size_t i = 0; i < 3; ++i)
        camera[i][i] = constant({1});
    return camera;
}

/// Turns as [ω]× R does at ω = 0. The first coordinate of the translation of view 2 is fixed.
static Camera calibrated_camera(Source& source, bool second) {
    const Dual a = source.fixed(), b = source.fixed(), c = source.fixed(), d = source.fixed();
    const Dual two = constant({2});
    const Camera rotation{
        Vector{a * a + b * b - c * c - d * d, two * (b * c + a * d), two * (b * d - a * c)},
        Vector{two * (b * c - a * d), a * a - b * b + c * c - d * d, two * (c * d + a * b)},
        Vector{two * (b * d + a * c), two * (c * d - a * b), a * a - b * b - c * c + d * d}};
    const Vector turn{source.varied({}), source.varied({}), source.varied({})};
    Camera camera;
    for (std::size_t i = 0; i < 3; ++i)
        camera[i] = plus(rotation[i], cross(turn, rotation[i]));
    camera[3][0] = second ? source.fixed() : source.unknown();
    camera[3][1] = source.unknown();
    camera[3][2] = source.unknown();
    return camera;
}

/// A matrix row by row, whose first entries are fixed.
static Camera projective_camera(Source& source, bool second) {
    Camera camera;
    for (std::size_t entry = 0; entry < 12; ++entry) {
        const bool fixed = entry < (second ? 5 : 1);
        camera[entry % 4][entry / 4] = fixed ? source.fixed() : source.unknown();
    }
    return camera;
}

/// The camera's matrix times (X, w).
static Vector image(const Camera& camera, const Vector& x, unsigned w) {
    Vector sum = times(constant({w}), camera[3]);
    for (std::size_t i = 0; i < 3; ++i)
        sum = plus(sum, times(x[i], camera[i]));
    return sum;
}

/// The row l·dx.
static std::vector<Residue> row(const Vector& l, const Vector& x) {
    Vector fixed;
    for (std::size_t i = 0; i < 3; ++i)
        fixed[i] = constant(l[i].value);
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

using Rows = std::vector<std::vector<Residue>>;

static void add_rows_of_view(Rows& rows, const Problem& problem, const Scene& scene,
                             const Camera& camera, unsigned view) {
    for (std::size_t p = 0; p < problem.points.size(); ++p) {
        if (!has_view(problem.points[p].seen_by, view)) continue;
        const Vector x = image(camera, scene.points[p], 1);
        const Dual zero{};
        rows.push_back(row({zero, x[2], zero - x[1]}, x));
        if (!is_dependent(problem, p, view)) rows.push_back(row({zero - x[2], zero, x[0]}, x));
    }
    for (std::size_t n = 0; n < problem.lines.size(); ++n) {
        const Line& line = problem.lines[n];
        if (!has_view(line.seen_by, view)) continue;
        const std::size_t seen_points = earlier_points(problem, n, problem.points.size(), view);
        const Vector a = image(camera, scene.lines[n].point, 1);
        const Vector e = image(camera, scene.lines[n].direction, 0);
        const Vector l = cross(a, e);
        if (seen_points == 0) rows.push_back(row(l, a));
        if (seen_points <= 1) rows.push_back(row(l, e));
    }
}

Residue jacobian_determinant(const Problem& problem, const Placement& placement) {
    Source source;
    source.read(placement.scene);
    const Scene scene = place_scene(problem, source);
    Rows rows;
    add_rows_of_view(rows, problem, scene, first_camera(), 0);
    for (unsigned view = 1; view <= placement.cameras.size(); ++view) {
        source.read(placement.cameras[view - 1]);
        const Camera camera = problem.projective ? projective_camera(source, view == 1)
                                                 : calibrated_camera(source, view == 1);
        add_rows_of_view(rows, problem, scene, camera, view);
    }
    for (std::vector<Residue>& row : rows)
        row.resize(source.unknowns());
    if (rows.size() != source.unknowns()) throw Refused("J is not square");
    return determinant(rows);
}
} // namespace checker::general
