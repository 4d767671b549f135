#include "checker/general_bounds/base_scenes.h"

#include "checker/file/complaint.h"
#include "checker/general_bounds/resection.h"

#include <algorithm>

namespace checker {
using Point4 = std::array<Small, 4>;

/// The own depths of the places of a line that are no points.
static std::vector<std::size_t> own_depths(const SceneSystem& system, std::size_t line) {
    std::vector<std::size_t> depths;
    for (const std::size_t place : system.lines[line])
        if (place >= system.points) depths.push_back(system.places[place].depth.size() - 1);
    return depths;
}

static bool is_on_large_line(const Problem& problem, std::size_t point) {
    return std::ranges::any_of(problem.points[point].lines, [&](std::size_t line) {
        return problem.lines[line].points.size() >= 3;
    });
}

static std::vector<std::size_t> joined(std::vector<std::size_t> a,
                                       const std::vector<std::size_t>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// The depths of a point and of the lines whose only point it is. The point's own depth moves other
/// points, too, if it is on a line with three or more.
static std::vector<std::size_t> depths_around(const Problem& problem, const SceneSystem& system,
                                              std::size_t point) {
    std::vector<std::size_t> depths;
    if (!is_on_large_line(problem, point)) depths.push_back(system.places[point].depth.size() - 1);
    for (const std::size_t line : problem.points[point].lines)
        depths = joined(depths, own_depths(system, line));
    return depths;
}

static bool share_a_point(const Line& a, const Line& b) {
    return std::ranges::any_of(
        a.points, [&](std::size_t point) { return std::ranges::binary_search(b.points, point); });
}

static std::vector<FewDepths> few_depths(const Problem& problem, const SceneSystem& system) {
    std::vector<FewDepths> found;
    for (std::size_t b = 0; b < problem.lines.size(); ++b) {
        const std::vector<std::size_t> depths = own_depths(system, b);
        if (depths.empty()) continue;
        found.push_back({depths, 2});
        for (std::size_t a = 0; a < b; ++a) {
            const std::vector<std::size_t> others = own_depths(system, a);
            if (others.empty() || share_a_point(problem.lines[a], problem.lines[b])) continue;
            found.push_back({joined(others, depths), 1});
        }
    }
    for (std::size_t point = 0; point < problem.points.size(); ++point) {
        const std::vector<std::size_t> depths = depths_around(problem, system, point);
        if (!depths.empty()) found.push_back({depths, 1});
    }
    return found;
}

/// Whether some points are at most two, or all points of a line.
static bool are_in_line(const Problem& problem, const Indices& points) {
    const auto has_these = [&](const Line& line) { return line.points == points; };
    return points.size() <= 2 || std::ranges::any_of(problem.lines, has_these);
}

/// Whether a line with three points or more has some points on the axis, and others not.
static bool splits_a_line(const Problem& problem, const Indices& on_axis) {
    return std::ranges::any_of(problem.lines, [&](const Line& line) {
        const auto count = std::ranges::count_if(line.points, [&](std::size_t point) {
            return std::ranges::binary_search(on_axis, point);
        });
        return line.points.size() >= 3 && count > 0 && count < std::ssize(line.points);
    });
}

/// What is on the axis: some points, and maybe a line of the problem, which then is the axis.
struct Axis {
    Indices points{};
    std::optional<std::size_t> line{};
};

/// Chooses for this line and those after it whether they meet the axis, and adds the pencils. The
/// images may put `conditions` more linear conditions on the camera; a pencil that leaves some is
/// left out where another one asks less of the scene.
static void choose_lines(const Problem& problem, const Axis& axis, Pencil& pencil, std::size_t line,
                         int conditions, std::vector<Pencil>& found) {
    if (conditions < 0) return;
    if (line == problem.lines.size()) {
        if (conditions == 0 || pencil.lines.empty()) found.push_back(pencil);
        return;
    }
    const auto go_on = [&](int cost) {
        choose_lines(problem, axis, pencil, line + 1, conditions - cost, found);
    };
    const Indices& points = problem.lines[line].points;
    if (points.size() >= 2 || axis.line == line) return go_on(0);
    if (points.size() == 1 && std::ranges::binary_search(axis.points, points[0])) return go_on(1);
    const int free = points.empty() ? 1 : 0;
    go_on(free + 1);
    pencil.lines.push_back(line);
    go_on(free);
    pencil.lines.pop_back();
}

/// The lines that an axis may be: those with no other point than it has, and one at most.
static std::vector<std::size_t> possible_axes(const Problem& problem, const Indices& points) {
    std::vector<std::size_t> lines;
    for (std::size_t line = 0; line < problem.lines.size(); ++line)
        if (points.size() <= 1 && problem.lines[line].points == points) lines.push_back(line);
    return lines;
}

static std::vector<Pencil> pencils(const Problem& problem, const SceneSystem& system) {
    std::vector<Pencil> found;
    for (std::size_t set = 0; set < std::size_t{1} << problem.points.size(); ++set) {
        Indices on_axis, others;
        for (std::size_t point = 0; point < problem.points.size(); ++point)
            ((set >> point & 1) != 0 ? on_axis : others).push_back(point);
        if (!are_in_line(problem, on_axis) || !are_in_line(problem, others)) continue;
        if (splits_a_line(problem, on_axis)) continue;
        constexpr int most = 5; // linear conditions have a common zero among six numbers
        const int conditions = others.size() <= 2 ? most - 2 * static_cast<int>(others.size()) : 0;
        Pencil pencil;
        for (std::size_t i = 0; i < std::min(on_axis.size(), std::size_t{2}); ++i)
            pencil.places.push_back(on_axis[i]);
        choose_lines(problem, {on_axis}, pencil, 0, conditions, found);
        for (const std::size_t line : possible_axes(problem, on_axis)) {
            pencil.places = {system.lines[line][0], system.lines[line][1]};
            choose_lines(problem, {on_axis, line}, pencil, 0, conditions, found);
        }
    }
    return found;
}

/// The lines whose only point this is.
static std::vector<std::size_t> lines_alone_at(const Problem& problem, std::size_t point) {
    std::vector<std::size_t> lines;
    for (const std::size_t line : problem.points[point].lines)
        if (problem.lines[line].points.size() == 1) lines.push_back(line);
    return lines;
}

/// Whether a line has three points, and but for one other point all points and all lines with one
/// point are there, and no line is without points.
static bool holds_almost_all(const Problem& problem, const Line& line,
                             const std::optional<std::size_t>& other) {
    if (line.points.size() != 3) return false;
    if (problem.points.size() != line.points.size() + (other ? 1 : 0)) return false;
    if (other && !lines_alone_at(problem, *other).empty()) return false;
    return std::ranges::none_of(problem.lines, [](const Line& l) { return l.points.empty(); });
}

static std::vector<Tangent> tangents(const Problem& problem) {
    std::vector<Tangent> found;
    for (std::size_t n = 0; n < problem.lines.size(); ++n) {
        const Line& line = problem.lines[n];
        std::optional<std::size_t> other;
        for (std::size_t point = 0; point < problem.points.size(); ++point)
            if (std::ranges::count(line.points, point) == 0) other = point;
        if (!holds_almost_all(problem, line, other)) continue;
        for (const std::size_t point : line.points) {
            const std::size_t lines = lines_alone_at(problem, point).size();
            if (lines == 1 || lines == 2) found.push_back({n, point, other});
        }
    }
    return found;
}

BaseScenes base_scenes(const Problem& problem, const SceneSystem& system) {
    return {few_depths(problem, system), pencils(problem, system), tangents(problem)};
}

std::array<SmallRow, 2> choose_tangent(const Problem& problem, const SceneSystem& system,
                                       const Tangent& tangent, Choices& choices) {
    const Indices& points = problem.lines[tangent.line].points;
    const Row3 a = residues(system.places[points[0]].x), b = residues(system.places[points[1]].x);
    // What is not on the line, projects to u a + v b, where the other point projects to 0.
    Row3 c{choices.next(), choices.next(), choices.next()};
    Small u = choices.next(), v = choices.next();
    if (tangent.other) {
        c = residues(system.places[*tangent.other].x);
        u = v = Small{};
    }
    const Small volume = determinant(a, b, c);
    if (volume == Small{}) throw Refused("view 1 is too special: take other images there");
    const auto projected = [&](const Row3& x) -> std::array<Small, 2> {
        const Small off = determinant(a, b, x);
        return {determinant(x, b, c) + off * u, determinant(a, x, c) + off * v};
    };
    const auto area = [&](const Row3& x, const Row3& y) {
        const auto p = projected(x), q = projected(y);
        return p[0] * q[1] - p[1] * q[0];
    };
    const Row3 centre = residues(system.places[tangent.point].x);
    SmallRow scene(system.depths), direction(system.depths);
    for (const std::size_t point : points)
        for (const std::size_t line : lines_alone_at(problem, point)) {
            const Place& place = system.places[system.lines[line][1]];
            const std::size_t depth = place.depth.size() - 1;
            if (point == tangent.point) {
                scene[depth] = choices.next();
                continue;
            }
            const Row3 x = residues(system.places[point].x);
            const Small divisor = area(x, centre);
            if (divisor == Small{}) throw Refused("view 1 is too special: take other images there");
            direction[depth] = -area(x, residues(place.x)) * divisor.inverse();
        }
    return {scene, direction};
}

SmallRow choose_scene(const SceneSystem& system, const FewDepths& few, Choices& choices) {
    SmallRow own(system.depths);
    for (const std::size_t depth : few.depths)
        own[depth] = choices.next();
    return own;
}

static Point4 point_at(const Place& place, Small depth) {
    const auto [x, y, z] = residues(place.x);
    return {x, y, z, depth};
}

/// The plane through three points.
static Point4 plane_through(const Point4& a, const Point4& b, const Point4& c) {
    const auto minor = [&](std::size_t i, std::size_t j, std::size_t k) {
        return a[i] * (b[j] * c[k] - b[k] * c[j]) - a[j] * (b[i] * c[k] - b[k] * c[i]) +
               a[k] * (b[i] * c[j] - b[j] * c[i]);
    };
    return {minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)};
}

SmallRow choose_scene(const SceneSystem& system, const Pencil& pencil, Choices& choices) {
    SmallRow own = choices.row(system.depths);
    const auto at = [&](std::size_t place) {
        return point_at(system.places[place], place_depths(system, own)[place]);
    };
    std::array<Point4, 2> axis{};
    for (std::size_t i = 0; i < axis.size(); ++i) {
        for (Small& coordinate : axis[i])
            coordinate = choices.next();
        if (i < pencil.places.size()) axis[i] = at(pencil.places[i]);
    }
    for (const std::size_t line : pencil.lines) {
        const auto& [start, end] = system.lines[line];
        const Point4 plane = plane_through(axis[0], axis[1], at(start));
        // A plane through the centre of camera 1 contains the end at each depth, or at none.
        if (plane[3] == Small{}) throw Refused("view 1 is too special: take other images there");
        const Point4 x = point_at(system.places[end], Small{});
        const Small sum = plane[0] * x[0] + plane[1] * x[1] + plane[2] * x[2];
        own[system.places[end].depth.size() - 1] = -sum * plane[3].inverse();
    }
    return own;
}
} // namespace checker
