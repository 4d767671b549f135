#include "tests/checker/minimal/image_rank.h"

#include "checker/problem/notation.h"

#include <algorithm>
#include <array>
#include <flint/nmod_mat.h>

using namespace checker;

namespace {

constexpr ulong prime = (1UL << 62) - 57;

/// A number modulo the prime, and its derivative in one direction.
struct Jet {
    ulong value = 0;
    ulong change = 0;
};

const nmod_t& field() {
    static const nmod_t result = [] {
        nmod_t made;
        nmod_init(&made, prime);
        return made;
    }();
    return result;
}

ulong add(ulong a, ulong b) {
    return nmod_add(a, b, field());
}

ulong multiply(ulong a, ulong b) {
    return nmod_mul(a, b, field());
}

Jet operator+(Jet a, Jet b) {
    return {add(a.value, b.value), add(a.change, b.change)};
}

Jet operator-(Jet a, Jet b) {
    return {nmod_sub(a.value, b.value, field()), nmod_sub(a.change, b.change, field())};
}

Jet operator*(Jet a, Jet b) {
    return {multiply(a.value, b.value),
            add(multiply(a.value, b.change), multiply(a.change, b.value))};
}

using Plane = std::array<Jet, 3>;
using Space = std::array<Jet, 4>;
using Matrix = std::array<Space, 3>;

Plane operator*(const Matrix& camera, const Space& x) {
    Plane image;
    for (std::size_t i = 0; i < 3; ++i)
        image[i] =
            camera[i][0] * x[0] + camera[i][1] * x[1] + camera[i][2] * x[2] + camera[i][3] * x[3];
    return image;
}

Plane join(const Plane& a, const Plane& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Random coordinates; one of them changes.
class Coordinates {
public:
    Coordinates(const std::vector<ulong>& values, std::size_t direction)
        : values_(values), direction_(direction) {}

    Jet take() {
        const std::size_t place = next_++;
        return {values_[place], place == direction_ ? 1UL : 0UL};
    }
    Space point() {
        const Jet x = take(), y = take(), z = take();
        return {x, y, z, {1, 0}};
    }
    Matrix camera(bool projective) {
        Matrix result;
        if (projective) {
            for (Space& row : result)
                for (Jet& entry : row)
                    entry = take();
            return result;
        }
        const Jet w = take(), x = take(), y = take(), z = take();
        const Jet ww = w * w, xx = x * x, yy = y * y, zz = z * z;
        const auto twice = [](Jet a) { return a + a; };
        result[0] = {ww + xx - yy - zz, twice(x * y - w * z), twice(x * z + w * y), take()};
        result[1] = {twice(x * y + w * z), ww - xx + yy - zz, twice(y * z - w * x), take()};
        result[2] = {twice(x * z - w * y), twice(y * z + w * x), ww - xx - yy + zz, take()};
        return result;
    }
    std::size_t taken() const { return next_; }

private:
    const std::vector<ulong>& values_;
    std::size_t direction_;
    std::size_t next_ = 0;
};

/// The two points of smallest numbers on the first line that has two before this point.
std::vector<std::size_t> ends_of_carrier(const Problem& problem, std::size_t point) {
    for (const Line& line : problem.lines)
        if (line.points.size() > 2 && line.points[1] < point &&
            std::ranges::count(line.points, point) > 0)
            return {line.points[0], line.points[1]};
    return {};
}

/// The derivatives of two ratios of coordinates, but for a factor that is not 0.
void add_ratios(std::vector<ulong>& changes, const Plane& image) {
    for (const std::size_t i : {0UL, 1UL})
        changes.push_back(nmod_sub(multiply(image[i].change, image[2].value),
                                   multiply(image[i].value, image[2].change), field()));
}

/// How all images change if the coordinate of this number does.
std::vector<ulong> changes_of(const Problem& problem, Coordinates& coordinates) {
    std::vector<Space> points;
    for (std::size_t p = 0; p < problem.points.size(); ++p) {
        const auto ends = ends_of_carrier(problem, p);
        if (ends.empty()) {
            points.push_back(coordinates.point());
            continue;
        }
        const Jet s = coordinates.take();
        Space mixed;
        for (std::size_t i = 0; i < 4; ++i)
            mixed[i] = points[ends[0]][i] + s * points[ends[1]][i];
        points.push_back(mixed);
    }
    std::vector<std::array<Space, 2>> lines;
    for (const Line& line : problem.lines) {
        std::vector<Space> ends;
        for (const std::size_t p : line.points)
            ends.push_back(points[p]);
        while (ends.size() < 2)
            ends.push_back(coordinates.point());
        lines.push_back({ends[0], ends[1]});
    }
    std::vector<ulong> changes;
    for (unsigned view = 0; has_view(problem.views, view); ++view) {
        const Matrix camera = coordinates.camera(problem.cameras == &checker::projective_cameras);
        for (std::size_t p = 0; p < points.size(); ++p)
            if (has_view(problem.points[p].seen_by, view)) add_ratios(changes, camera * points[p]);
        for (std::size_t n = 0; n < lines.size(); ++n)
            if (has_view(problem.lines[n].seen_by, view))
                add_ratios(changes, join(camera * lines[n][0], camera * lines[n][1]));
    }
    return changes;
}

bool is_dependent(const Problem& problem, std::size_t point) {
    return !ends_of_carrier(problem, point).empty();
}

/// A line that may get one more point, or SIZE_MAX if there is none among the lines tried.
std::size_t line_with_two(const Problem& problem, Dice& dice) {
    if (problem.lines.empty()) return SIZE_MAX;
    const std::size_t n = dice.below(problem.lines.size());
    return problem.lines[n].points.size() >= 2 ? n : SIZE_MAX;
}

void put(Problem& problem, std::size_t point, std::size_t line) {
    problem.lines[line].points.push_back(point);
    problem.points[point].lines.push_back(line);
}

bool joined(const Problem& problem, std::size_t p, std::size_t q) {
    return std::ranges::any_of(problem.lines, [&](const Line& line) {
        return std::ranges::count(line.points, p) > 0 && std::ranges::count(line.points, q) > 0;
    });
}

void add_point(Problem& problem, Dice& dice) {
    const std::size_t point = problem.points.size();
    problem.points.emplace_back();
    const std::size_t carrier = dice.one_in(2) ? line_with_two(problem, dice) : SIZE_MAX;
    if (carrier != SIZE_MAX) put(problem, point, carrier);
    for (int tries = dice.from_to(0, 2); tries > 0 && point > 0; --tries) {
        const std::size_t other = dice.below(point);
        if (joined(problem, point, other)) continue;
        problem.lines.emplace_back();
        put(problem, other, problem.lines.size() - 1);
        put(problem, point, problem.lines.size() - 1);
    }
}

/// Lets views see what they have to, as they see something else.
void complete_views(Problem& problem) {
    for (int pass = 0; pass < 20; ++pass) {
        for (std::size_t p = 0; p < problem.points.size(); ++p)
            for (std::size_t q = 0; q < p; ++q)
                for (Line& line : problem.lines)
                    if (std::ranges::count(line.points, p) && std::ranges::count(line.points, q))
                        line.seen_by |= problem.points[p].seen_by & problem.points[q].seen_by;
        for (Point& point : problem.points)
            for (const std::size_t a : point.lines)
                for (const std::size_t b : point.lines)
                    if (a != b)
                        point.seen_by |= problem.lines[a].seen_by & problem.lines[b].seen_by;
    }
}

} // namespace

std::size_t image_rank(const Problem& problem, Dice& dice) {
    std::vector<ulong> values(1200);
    for (ulong& value : values)
        value = dice.below(prime);
    Coordinates first(values, SIZE_MAX);
    const std::size_t rows = changes_of(problem, first).size();
    nmod_mat_t jacobian;
    nmod_mat_init(jacobian, static_cast<slong>(first.taken()), static_cast<slong>(rows), prime);
    for (std::size_t direction = 0; direction < first.taken(); ++direction) {
        Coordinates coordinates(values, direction);
        const std::vector<ulong> changes = changes_of(problem, coordinates);
        for (std::size_t c = 0; c < rows; ++c)
            nmod_mat_entry(jacobian, direction, c) = changes[c];
    }
    const auto rank = static_cast<std::size_t>(nmod_mat_rank(jacobian));
    nmod_mat_clear(jacobian);
    return rank;
}

std::size_t image_dimension(const Problem& problem) {
    int dimension = 0;
    for (unsigned view = 0; has_view(problem.views, view); ++view) {
        for (const Point& point : problem.points)
            dimension += has_view(point.seen_by, view) ? 2 : 0;
        for (const Line& line : problem.lines) {
            if (!has_view(line.seen_by, view)) continue;
            const auto is_seen = [&](std::size_t p) {
                return has_view(problem.points[p].seen_by, view);
            };
            dimension += 2 - static_cast<int>(std::ranges::count_if(line.points, is_seen));
        }
    }
    return static_cast<std::size_t>(dimension);
}

std::size_t scene_dimension(const Problem& problem) {
    const auto views = static_cast<std::size_t>(std::popcount(problem.views));
    std::size_t dimension =
        problem.cameras == &checker::projective_cameras ? 11 * views - 15 : 6 * views - 7;
    for (std::size_t p = 0; p < problem.points.size(); ++p)
        dimension += is_dependent(problem, p) ? 1 : 3;
    for (const Line& line : problem.lines)
        if (line.points.size() < 2) dimension += line.points.empty() ? 4 : 2;
    return dimension;
}

Problem random_problem(Dice& dice, bool all_visible) {
    Problem problem{.cameras = dice.one_in(2) ? &checker::projective_cameras
                                              : &checker::calibrated_cameras};
    const int views = dice.from_to(2, 6);
    problem.views = (1U << views) - 1;
    for (int points = dice.from_to(0, 7); points > 0; --points)
        add_point(problem, dice);
    for (int lines = dice.from_to(0, 3); lines > 0; --lines) {
        problem.lines.emplace_back();
        if (!problem.points.empty() && dice.one_in(2))
            put(problem, dice.below(problem.points.size()), problem.lines.size() - 1);
    }
    const auto sight = [&] {
        Views seen = problem.views;
        for (int view = 0; view < views && !all_visible; ++view)
            if (dice.one_in(5)) seen &= ~(1U << view);
        return seen;
    };
    for (Point& point : problem.points)
        point.seen_by = sight();
    for (Line& line : problem.lines)
        line.seen_by = sight();
    complete_views(problem);
    return std::string(violation(problem)).empty() ? problem : random_problem(dice, all_visible);
}

Problem problem_of(const std::string& notation) {
    const std::string line = notation + '\n';
    checker::Reader reader(line);
    return read_notation(reader).problem;
}
