// Draws on a raster of characters. A feature is sketched once, as marks around its point; each
// panel then shows every mark in the glyph for seen or for unseen, so that the panels cannot
// disagree about places.
#include "prover/drawing/caption.h"
#include "prover/drawing/drawing.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace plprove {

namespace {

constexpr int gap = 3;           // columns between neighbours
constexpr int page_columns = 98; // of all panels together
constexpr int point = -1;        // the element of a mark that is no line

/// One character of a sketch, relative to the place of the feature.
struct Mark {
    int x = 0;
    int y = 0;
    int element = point; ///< the line that it belongs to, or `point`
    std::string seen;
    std::string unseen;
};

struct Sketch {
    std::vector<Mark> marks;
    int left = 0, right = 0, top = 0, bottom = 0; ///< its extent, all inclusive

    void add(Mark mark) {
        left = std::min(left, mark.x);
        right = std::max(right, mark.x);
        top = std::min(top, mark.y);
        bottom = std::max(bottom, mark.y);
        marks.push_back(std::move(mark));
    }
    void add_stroke(int x, int y, int line, const char* glyph) { add({x, y, line, glyph, "·"}); }
    void add_letter(int x, int y, int line) {
        add({x, y, line, std::string(1, static_cast<char>('a' + line)), " "});
    }
    int width() const { return right - left + 1; }
};

/// The eight directions in which up to eight pins leave their point.
enum Direction { NW, N, NE, E, SE, S, SW, W };

void add_ray(Sketch& sketch, Direction direction, int line) {
    struct Ray {
        int x, y;
        const char* glyph;
        int letter_x, letter_y;
    };
    static constexpr std::array<Ray, 8> rays{{{-1, -1, "╲", -2, -1},
                                              {0, -1, "│", 0, -2},
                                              {1, -1, "╱", 2, -1},
                                              {1, 0, "─", 3, 0},
                                              {1, 1, "╲", 2, 1},
                                              {0, 1, "│", 0, 2},
                                              {-1, 1, "╱", -2, 1},
                                              {-1, 0, "─", -3, 0}}};
    const Ray& ray = rays[direction];
    sketch.add_stroke(ray.x, ray.y, line, ray.glyph);
    // A character is twice as high as wide.
    if (ray.y == 0) sketch.add_stroke(2 * ray.x, 0, line, ray.glyph);
    sketch.add_letter(ray.letter_x, ray.letter_y, line);
}

/// Half of more than eight pins: a row of strokes above (side -1) or below (side 1) the point.
void add_fan(Sketch& sketch, int side, int first, int count) {
    for (int i = 0; i < count; ++i) {
        const int x = 2 * i - (count - 1);
        const bool rising = (x < 0) == (side > 0);
        const char* glyph = x == 0 ? "│" : rising ? "╱" : "╲";
        sketch.add_stroke(x, side, first + i, glyph);
        sketch.add_letter(x + (x > 0) - (x < 0), 2 * side, first + i);
    }
}

Sketch sketch_of(const Feature& feature) {
    static const std::array<std::vector<Direction>, 9> directions{{{},
                                                                   {E},
                                                                   {NW, NE},
                                                                   {W, NE, SE},
                                                                   {NW, NE, SE, SW},
                                                                   {NW, NE, E, SE, SW},
                                                                   {NW, NE, E, SE, SW, W},
                                                                   {NW, N, NE, E, SE, SW, W},
                                                                   {NW, N, NE, E, SE, S, SW, W}}};
    Sketch sketch;
    if (!feature.has_point) {
        sketch.add_letter(0, 0, 0);
        for (int x = 1; x <= 5; ++x)
            sketch.add_stroke(x, 0, 0, "─");
        return sketch;
    }
    sketch.add({0, 0, point, "●", "○"});
    const auto pins = static_cast<std::size_t>(feature.lines);
    if (pins < directions.size()) {
        for (std::size_t i = 0; i < pins; ++i)
            add_ray(sketch, directions[pins][i], static_cast<int>(i));
    } else {
        const int above = (feature.lines + 1) / 2;
        add_fan(sketch, -1, 0, above);
        add_fan(sketch, 1, above, feature.lines - above);
    }
    return sketch;
}

/// Consecutive features that stand side by side.
struct Row {
    std::size_t begin = 0, end = 0;
};

std::vector<Row> rows_of_width(const std::vector<Sketch>& sketches, int columns) {
    std::vector<Row> rows;
    int used = 0;
    for (std::size_t i = 0; i < sketches.size(); ++i) {
        used += gap + sketches[i].width();
        if (rows.empty() || used > columns) {
            rows.push_back({i, i});
            used = sketches[i].width();
        }
        rows.back().end = i + 1;
    }
    return rows;
}

int width_of(const std::vector<Sketch>& sketches, const Row& row) {
    int width = -gap;
    for (std::size_t i = row.begin; i < row.end; ++i)
        width += gap + sketches[i].width();
    return width;
}

/// As few rows as `columns` allows, and among those the narrowest, so that rows are about equally
/// long.
std::vector<Row> balanced_rows(const std::vector<Sketch>& sketches, int columns) {
    std::vector<Row> rows = rows_of_width(sketches, columns);
    for (int narrower = columns - 1; narrower > 0; --narrower) {
        std::vector<Row> attempt = rows_of_width(sketches, narrower);
        if (attempt.size() > rows.size()) break;
        rows = std::move(attempt);
    }
    return rows;
}

/// The lines of text that a row of features fills in one view, all `columns` wide.
std::vector<std::string> raster(const Features& problem, const std::vector<Sketch>& sketches,
                                const Row& row, int view, int columns) {
    int top = 0;
    int bottom = 0;
    for (std::size_t i = row.begin; i < row.end; ++i) {
        top = std::min(top, sketches[i].top);
        bottom = std::max(bottom, sketches[i].bottom);
    }
    std::vector<std::vector<std::string>> cells(
        static_cast<std::size_t>(bottom - top + 1),
        std::vector<std::string>(static_cast<std::size_t>(columns), " "));
    int x = (columns - width_of(sketches, row)) / 2;
    for (std::size_t i = row.begin; i < row.end; ++i) {
        for (const Mark& mark : sketches[i].marks) {
            const bool seen = mark.element == point ? problem[i].sees_point(view)
                                                    : problem[i].sees_line(view, mark.element);
            cells[static_cast<std::size_t>(mark.y - top)]
                 [static_cast<std::size_t>(x + mark.x - sketches[i].left)] =
                     seen ? mark.seen : mark.unseen;
        }
        x += sketches[i].width() + gap;
    }
    std::vector<std::string> lines;
    for (const auto& line : cells)
        lines.push_back(std::accumulate(line.begin(), line.end(), std::string()));
    return lines;
}

std::string repeat(const std::string& text, int times) {
    std::string result;
    for (int i = 0; i < times; ++i)
        result += text;
    return result;
}

/// The lines of one view's panel, frame included.
std::vector<std::string> panel(const Features& problem, const std::vector<Sketch>& sketches,
                               const std::vector<Row>& rows, int view, int columns) {
    const std::string empty = "│ " + repeat(" ", columns) + " │";
    std::vector<std::string> lines{"┌─ view " + std::to_string(view + 1) + " " +
                                   repeat("─", columns - 7) + "┐"};
    for (const Row& row : rows) {
        lines.push_back(empty);
        for (const std::string& line : raster(problem, sketches, row, view, columns))
            lines.push_back("│ " + line + " │");
    }
    lines.push_back(empty);
    lines.push_back("└" + repeat("─", columns + 2) + "┘");
    return lines;
}

} // namespace

std::string draw_text(const Features& problem) {
    std::string text;
    for (const std::string& line : caption(problem, page_columns))
        text += line + "\n";
    const int views = problem.empty() ? 0 : problem.front().views();
    if (views == 0) return text;

    std::vector<Sketch> sketches;
    for (const Feature& feature : problem)
        sketches.push_back(sketch_of(feature));
    // Each panel has a frame of two columns left and right; a blank is between panels.
    const std::vector<Row> rows = balanced_rows(sketches, (page_columns + 1) / views - 5);
    int columns = 12;
    for (const Row& row : rows)
        columns = std::max(columns, width_of(sketches, row));

    std::vector<std::vector<std::string>> panels;
    for (int view = 0; view < views; ++view)
        panels.push_back(panel(problem, sketches, rows, view, columns));
    for (std::size_t line = 0; line < panels.front().size(); ++line)
        for (std::size_t view = 0; view < panels.size(); ++view)
            text += panels[view][line] + (view + 1 < panels.size() ? " " : "\n");
    return text + "seen: ● point, ─ ╱ │ ╲ line with its letter; not seen: ○ point, · line\n";
}

} // namespace plprove
