#include "prover/drawing/picture.h"

#include "prover/minimal/obstruction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plprove {

namespace {

constexpr double least_panel_width = 160;
constexpr double least_cell = 38;

struct Place {
    double x = 0;
    double y = 0;
    double angle = 0; ///< of its first line, in half turns
};

/// Where the features are, the same in every view: feature i within `radius` of places[i], no two
/// of these discs overlapping.
struct Layout {
    double width = 0;
    double height = 0;
    double radius = 0;
    std::vector<Place> places;
};

double fraction(double x) {
    return x - std::floor(x);
}

/// The row and column of each feature in a grid that is read like the notation and evenly filled.
struct Cell {
    double row = 0;
    double column = 0;
    double columns = 0; ///< in this row
};

std::vector<Cell> grid(std::size_t features, std::size_t rows) {
    std::vector<Cell> cells;
    for (std::size_t row = 0; row < rows; ++row) {
        const std::size_t begin = row * features / rows;
        const std::size_t end = (row + 1) * features / rows;
        for (std::size_t i = begin; i < end; ++i)
            cells.push_back({static_cast<double>(row), static_cast<double>(i - begin),
                             static_cast<double>(end - begin)});
    }
    return cells;
}

/// Real pictures are in general position. So each feature leaves the middle of its cell by
/// multiples of irrational numbers modulo 1, which never repeat, and its lines are turned
/// likewise. The multiples are squares, as a sequence of constant steps has collinear points, and
/// the numbers those that keep the points of up to 20 features farthest from being collinear.
Layout layout(std::size_t features) {
    const double count = static_cast<double>(features);
    const double rows = std::max(1.0, std::round(std::sqrt(count * 3 / 4)));
    Layout result;
    result.width = std::max(least_panel_width, std::ceil(count / rows) * least_cell);
    result.height = std::max(result.width * 3 / 4, rows * least_cell);
    const double cell_height = result.height / rows;
    const double cell = std::min(result.width / std::ceil(count / rows), cell_height);
    result.radius = std::min(0.36 * cell, 30.0);
    const auto leeway = [&](double side) {
        return std::min(side / 2 - result.radius - 2, 0.3 * cell);
    };

    double number = 0;
    for (const Cell& at : grid(features, static_cast<std::size_t>(rows))) {
        const double cell_width = result.width / at.columns;
        const double dx = 2 * fraction(0.7 + number * number * 0.385164807) - 1; // of sqrt(29)
        const double dy = 2 * fraction(number * number * 0.795831523) - 1;       // of sqrt(23)
        result.places.push_back({cell_width * (at.column + 0.5) + leeway(cell_width) * dx,
                                 cell_height * (at.row + 0.5) + leeway(cell_height) * dy,
                                 fraction(0.12 + number * 0.618033989)});
        ++number;
    }
    return result;
}

/// The stroke of line number `line` of `lines` through a place.
Stroke stroke_of(const Place& place, double radius, int line, int lines, bool seen) {
    const double angle = std::numbers::pi * (place.angle + static_cast<double>(line) / lines);
    const double dx = radius * std::cos(angle);
    const double dy = radius * std::sin(angle);
    // Many lines through one point have to stay apart.
    const double width = std::min(seen ? 1.3 : 1.1, radius / lines);
    return {place.x - dx, place.y - dy, place.x + dx,
            place.y + dy, width,        seen ? Ink::seen : Ink::unseen};
}

/// The letter of a line, beside its end, before the next line.
Letter letter_of(const Place& place, double radius, int line, int lines) {
    const double space = std::numbers::pi * radius / lines;
    const double size = std::min(8.0, 0.7 * space);
    const double distance = radius - size / 2;
    const double half_way = std::numbers::pi / (2 * lines);
    const double aside = std::min((size / 2 + 1.5) / distance, half_way);
    const double angle =
        std::numbers::pi * (place.angle + static_cast<double>(line) / lines) + aside;
    return {place.x + distance * std::cos(angle), place.y + distance * std::sin(angle), size,
            static_cast<char>('a' + line)};
}

Dot dot_of(const Place& place, double radius, int lines, Ink ink) {
    // A white rim tells an unseen point from the seen lines through it, and any point from many
    // lines.
    const bool rim = ink == Ink::unseen || lines > 7;
    return {place.x, place.y, std::min(rim ? 3.4 : 3.0, radius / 3), rim, ink};
}

/// What one view sees and does not see of a feature, the latter underneath.
void draw(Panel& panel, const Feature& feature, const Place& place, double radius, int view,
          bool highlighted) {
    for (const bool seen : {false, true})
        for (int line = 0; line < feature.lines; ++line)
            if (feature.sees_line(view, line) == seen)
                panel.push_back(stroke_of(place, radius, line, feature.lines, seen));
    for (int line = 0; line < feature.lines; ++line)
        if (feature.sees_line(view, line))
            panel.push_back(letter_of(place, radius, line, feature.lines));
    if (!feature.has_point) return;
    const Ink ink = highlighted                ? Ink::highlighted
                    : feature.sees_point(view) ? Ink::seen
                                               : Ink::unseen;
    panel.push_back(dot_of(place, radius, feature.lines, ink));
}

/// Whether the view and another one, which share exactly five points, both see this one.
bool in_five_points(const Features& problem, const Feature& feature, int view) {
    const std::array<int, 3> shared = shared_points(problem);
    const int views = problem.front().views();
    for (std::size_t i = 0; i < view_pairs.size(); ++i) {
        const auto [first, second] = view_pairs[i];
        if (second >= views || shared[i] != 5) continue;
        const bool of_the_pair = view == first || view == second;
        if (of_the_pair && feature.sees_point(first) && feature.sees_point(second)) return true;
    }
    return false;
}

} // namespace

/// At most two decimals, whatever the locale.
std::string number(double value) {
    const auto hundredths = std::llround(value * 100);
    const auto size = std::abs(hundredths);
    std::string text = (hundredths < 0 ? "-" : "") + std::to_string(size / 100);
    if (size % 100 != 0) text += "." + std::to_string(size / 10 % 10);
    if (size % 10 != 0) text += std::to_string(size % 10);
    return text;
}

bool has_five_points(const Features& problem) {
    const std::array<int, 3> shared = shared_points(problem);
    return std::ranges::find(shared, 5) != shared.end();
}

Picture picture_of(const Features& problem, Highlight highlight) {
    const Layout places = layout(problem.size());
    Picture picture{places.width, places.height, {}};
    const int views = problem.empty() ? 0 : problem.front().views();
    for (int view = 0; view < views; ++view) {
        Panel& panel = picture.panels.emplace_back();
        for (std::size_t i = 0; i < problem.size(); ++i) {
            const bool highlighted =
                highlight == Highlight::five_points && in_five_points(problem, problem[i], view);
            draw(panel, problem[i], places.places[i], places.radius, view, highlighted);
        }
    }
    return picture;
}

} // namespace plprove
