// Places the features of a problem in general position, no three points on a line, and writes the
// panels.
#include "prover/drawing/caption.h"
#include "prover/drawing/drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plprove {

namespace {

// All lengths are in user units, one of which is meant as a point of a printed page.
constexpr double least_panel_width = 160;
constexpr double least_cell = 38;
constexpr double panel_gap = 14;
constexpr double margin = 4;
constexpr double title_height = 18;
constexpr double line_height = 14;
constexpr double character_width = 6; // of the caption's 10 unit type, which is fixed-width

const std::string black = "#000";
const std::string grey = "#bbb";

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
/// multiples of irrational numbers modulo 1, of which none repeats, and its lines are turned
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

/// At most two decimals, whatever the locale.
std::string number(double value) {
    const auto hundredths = std::llround(value * 100);
    const auto size = std::abs(hundredths);
    std::string text = (hundredths < 0 ? "-" : "") + std::to_string(size / 100);
    if (size % 100 != 0) text += "." + std::to_string(size / 10 % 10);
    if (size % 10 != 0) text += std::to_string(size % 10);
    return text;
}

std::string attribute(const std::string& name, const std::string& value) {
    return " " + name + "=\"" + value + "\"";
}
std::string attribute(const std::string& name, double value) {
    return attribute(name, number(value));
}

std::string line_element(const Place& place, double radius, int line, int lines, bool seen) {
    const double angle = std::numbers::pi * (place.angle + static_cast<double>(line) / lines);
    const double dx = radius * std::cos(angle);
    const double dy = radius * std::sin(angle);
    // Many lines through one point have to stay apart.
    const double width = std::min(seen ? 1.3 : 1.1, radius / lines);
    return "<line" + attribute("class", seen ? "seen" : "unseen") + attribute("x1", place.x - dx) +
           attribute("y1", place.y - dy) + attribute("x2", place.x + dx) +
           attribute("y2", place.y + dy) + attribute("stroke", seen ? black : grey) +
           attribute("stroke-width", width) + "/>\n";
}

std::string point_element(const Place& place, double radius, int lines, bool seen) {
    // A white rim tells an unseen point from the seen lines through it, and any point from many
    // lines.
    const bool rim = !seen || lines > 7;
    return "<circle" + attribute("class", seen ? "seen" : "unseen") + attribute("cx", place.x) +
           attribute("cy", place.y) + attribute("r", std::min(rim ? 3.4 : 3.0, radius / 3)) +
           attribute("fill", seen ? black : grey) +
           (rim ? " stroke=\"#fff\" stroke-width=\"0.8\"" : "") + "/>\n";
}

/// What one view sees and does not see of a feature, the latter underneath.
std::string drawing_of(const Feature& feature, const Place& place, double radius, int view) {
    std::string text;
    for (const bool seen : {false, true})
        for (int line = 0; line < feature.lines; ++line)
            if (feature.sees_line(view, line) == seen)
                text += line_element(place, radius, line, feature.lines, seen);
    if (feature.has_point)
        text += point_element(place, radius, feature.lines, feature.sees_point(view));
    return text;
}

std::string text_element(double x, double y, const std::string& attributes,
                         const std::string& text) {
    return "<text" + attribute("x", x) + attribute("y", y) + " text-anchor=\"middle\"" +
           attributes + ">" + text + "</text>\n";
}

} // namespace

std::string draw_svg(const Problem& problem) {
    const Layout places = layout(problem.size());
    const int views = problem.empty() ? 0 : problem.front().views();
    const double panels_width = views * (places.width + panel_gap) - panel_gap;
    const double caption_top = margin + title_height + places.height + 6;
    const auto columns = static_cast<std::size_t>(panels_width / character_width);
    const std::vector<std::string> captions = caption(problem, columns);
    // A single summand may be wider than the panels.
    std::size_t longest = 0;
    for (const std::string& line : captions)
        longest = std::max(longest, line.size());
    const double width =
        2 * margin + std::max(panels_width, character_width * static_cast<double>(longest));
    const double left = (width - panels_width) / 2;
    const double height = caption_top + line_height * static_cast<double>(captions.size()) + margin;

    std::string svg = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                      "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\"" +
                      attribute("width", width) + attribute("height", height) +
                      attribute("viewBox", "0 0 " + number(width) + " " + number(height)) +
                      " style=\"background:#fff\">\n";
    svg += "<title>" + notation(problem) +
           "</title>\n<desc>A point-line problem: " + describe(problem) +
           ". Each panel is one view, with every feature at the same place. Points and lines that "
           "the view sees are black, those that it does not see are grey.</desc>\n";
    svg += "<g font-family=\"Helvetica, Arial, sans-serif\" font-size=\"11\">\n";
    for (int view = 0; view < views; ++view) {
        svg +=
            "<g" + attribute("id", "view-" + std::to_string(view + 1)) +
            attribute("transform", "translate(" + number(left + view * (places.width + panel_gap)) +
                                       " " + number(margin + title_height) + ")") +
            ">\n";
        svg += text_element(places.width / 2, -6, "", "view " + std::to_string(view + 1));
        svg += "<rect" + attribute("width", places.width) + attribute("height", places.height) +
               " fill=\"none\" stroke=\"#808080\" stroke-width=\"0.6\"/>\n"
               "<g stroke-linecap=\"round\">\n";
        for (std::size_t i = 0; i < problem.size(); ++i)
            svg += drawing_of(problem[i], places.places[i], places.radius, view);
        svg += "</g>\n</g>\n";
    }
    svg += "</g>\n<g font-family=\"Menlo, Consolas, 'DejaVu Sans Mono', monospace\" "
           "font-size=\"10\">\n";
    for (std::size_t i = 0; i < captions.size(); ++i)
        svg += text_element(width / 2, caption_top + line_height * (static_cast<double>(i) + 0.75),
                            "", captions[i]);
    return svg + "</g>\n</svg>\n";
}

} // namespace plprove
