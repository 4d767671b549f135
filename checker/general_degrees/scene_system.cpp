#include "checker/general_degrees/scene_system.h"

#include <span>

namespace checker {
/// What a view shows: its points, two points of each of its lines, and the factors that make a
/// dependent point from the first two of its carrier.
struct Picture {
    std::vector<ImageCoordinates> points{};
    std::vector<std::array<std::int64_t, 2>> factors{};
    std::vector<std::array<ImageCoordinates, 2>> lines{};
};

static std::int64_t bounded(std::int64_t coordinate) {
    constexpr std::int64_t largest = 1'000'000'000;
    if (std::abs(coordinate) > largest) throw Refused("a coordinate of the images is too large");
    return coordinate;
}

static std::int64_t combination(const std::array<std::int64_t, 2>& factors, std::int64_t a,
                                std::int64_t b) {
    return bounded(factors[0] * a + factors[1] * b);
}

/// The line through two image points, or the other way round. It must not be zero.
static ImageCoordinates join(const ImageCoordinates& a, const ImageCoordinates& b) {
    const ImageCoordinates line = cross(a, b);
    if (line == ImageCoordinates{}) throw Refused("two image points of a line are the same");
    return line;
}

/// The two lines through an image point that its equations are made with.
static std::array<ImageCoordinates, 2> lines_through(const ImageCoordinates& y) {
    return {ImageCoordinates{0, y[2], -y[1]}, ImageCoordinates{-y[2], 0, y[0]}};
}

std::size_t depths_of(const Problem& problem) {
    const SceneParts parts = scene_parts(problem);
    return parts.free + parts.of_lines;
}

std::size_t numbers_of_view(const Problem& problem) {
    const auto [free, carried, of_lines] = scene_parts(problem);
    return 3 * free + 2 * carried + 3 * of_lines;
}

Numbers read_view(Reader& reader, const Problem& problem) {
    Numbers numbers;
    for (std::size_t left = numbers_of_view(problem); left > 0; --left)
        numbers.push_back(reader.small_integer(-999'999'999, 999'999'999));
    reader.end_line();
    return numbers;
}

static ImageCoordinates take_vector(std::span<const int>& numbers) {
    const ImageCoordinates vector{numbers[0], numbers[1], numbers[2]};
    numbers = numbers.subspan(3);
    return vector;
}

/// Adds a point that lies on a line through two points before.
static void add_dependent(Picture& picture, const Line& carrier, std::span<const int>& numbers) {
    const ImageCoordinates& a = picture.points[carrier.points[0]];
    const ImageCoordinates& b = picture.points[carrier.points[1]];
    picture.factors.back() = {numbers[0], numbers[1]};
    numbers = numbers.subspan(2);
    ImageCoordinates point;
    for (std::size_t i = 0; i < 3; ++i)
        point[i] = combination(picture.factors.back(), a[i], b[i]);
    if (dot(lines_through(point)[0], a) == 0)
        throw Refused("an image point is too special: its auxiliary line contains another point");
    picture.points.push_back(point);
}

static Picture picture_of(const Problem& problem, std::span<const int> numbers) {
    Picture picture;
    for (std::size_t p = 0; p < problem.points.size(); ++p) {
        picture.factors.emplace_back();
        if (const auto on = carrier(problem, p))
            add_dependent(picture, problem.lines[*on], numbers);
        else
            picture.points.push_back(take_vector(numbers));
        if (picture.points[p][2] == 0) throw Refused("an image point has 0 as third coordinate");
    }
    for (const Line& line : problem.lines) {
        const std::size_t known = line.points.size();
        const ImageCoordinates a =
            known > 0 ? picture.points[line.points[0]] : take_vector(numbers);
        const ImageCoordinates b =
            known > 1 ? picture.points[line.points[1]] : take_vector(numbers);
        join(a, b);
        picture.lines.push_back({a, b});
    }
    return picture;
}

/// Adds a place at a new depth, and returns its number.
static std::size_t add_place(SceneSystem& system, const ImageCoordinates& x) {
    DepthForm depth(system.depths + 1);
    depth[system.depths++] = 1;
    system.places.push_back({x, depth});
    return system.places.size() - 1;
}

/// Adds the place of a dependent point, as view 1 shows it.
static void add_dependent(SceneSystem& system, const Line& carrier, const Picture& first,
                          std::size_t p) {
    DepthForm a = system.places[carrier.points[0]].depth;
    DepthForm b = system.places[carrier.points[1]].depth;
    DepthForm depth(std::max(a.size(), b.size()));
    a.resize(depth.size());
    b.resize(depth.size());
    for (std::size_t k = 0; k < depth.size(); ++k)
        depth[k] = combination(first.factors[p], a[k], b[k]);
    system.places.push_back({first.points[p], depth});
}

/// Adds all places, as view 1 shows them.
static void add_places(SceneSystem& system, const Problem& problem, const Picture& first) {
    for (std::size_t p = 0; p < problem.points.size(); ++p) {
        if (const auto on = carrier(problem, p))
            add_dependent(system, problem.lines[*on], first, p);
        else
            add_place(system, first.points[p]);
    }
    system.points = system.places.size();
    for (std::size_t n = 0; n < problem.lines.size(); ++n) {
        const Indices& points = problem.lines[n].points;
        const auto& [a, b] = first.lines[n];
        const std::size_t start = points.size() > 0 ? points[0] : add_place(system, a);
        const std::size_t end = points.size() > 1 ? points[1] : add_place(system, b);
        system.lines.push_back({start, end});
    }
}

/// Adds what a view but the first says of the places.
static void add_equations(SceneSystem& system, const Problem& problem, const Picture& picture,
                          std::size_t camera) {
    for (std::size_t p = 0; p < system.points; ++p) {
        const auto [first, second] = lines_through(picture.points[p]);
        system.equations.push_back({camera, first, p});
        if (!carrier(problem, p)) system.equations.push_back({camera, second, p});
    }
    for (std::size_t n = 0; n < problem.lines.size(); ++n) {
        const ImageCoordinates line = join(picture.lines[n][0], picture.lines[n][1]);
        for (const std::size_t place : system.lines[n])
            if (place >= system.points) system.equations.push_back({camera, line, place});
    }
}

CameraForm camera_form(const CameraModel& model, bool second) {
    CameraForm form{.shared = model.shared,
                    .coordinates = model.unknowns_of(second),
                    .matrix = model.of_solution(second)};
    for (std::size_t k = 0; k < form.shared + form.coordinates; ++k)
        for (std::size_t column = 0; column < 4; ++column)
            for (std::size_t row = 0; row < 3; ++row) {
                const CoordinatePolynomial change = derivative(form.matrix[column][row], k);
                if (!change.terms.empty()) form.changes.push_back({k, row, column, change});
            }
    return form;
}

SceneSystem scene_system(const Problem& problem, const std::vector<Numbers>& views) {
    if (surplus(problem) != 0) throw Refused("it is not balanced, so it has no degree");
    if (!all_views_see_all(problem)) throw Refused("some view misses a point or a line");
    SceneSystem system{.second = camera_form(*problem.cameras, true),
                       .other = camera_form(*problem.cameras, false),
                       .cameras = views.size() - 1};
    add_places(system, problem, picture_of(problem, views[0]));
    for (std::size_t view = 1; view < views.size(); ++view)
        add_equations(system, problem, picture_of(problem, views[view]), view - 1);
    return system;
}
} // namespace checker
