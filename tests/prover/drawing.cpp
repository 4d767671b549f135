// Pictures of problems: what is in every panel, by laws.
#include "prover/drawing/drawing.h"
#include "tests/support/drawn_problems.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <map>
#include <regex>
#include <sstream>

using namespace plprove;

namespace {

/// One element of a drawing: `line` or `circle`, seen or not, and where.
struct Element {
    std::string name;
    bool seen = false;
    std::string place;
    auto operator<=>(const Element&) const = default;
};

using Panel = std::vector<Element>;

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t from = text.find(begin);
    REQUIRE(from != std::string::npos);
    const std::size_t to = text.find(end, from + begin.size());
    REQUIRE(to != std::string::npos);
    return text.substr(from, to - from);
}

Panel svg_panel(const std::string& svg, int view) {
    static const std::regex element(
        R"re(<(line|circle) class="(seen|unseen)"((?: (?:x1|y1|x2|y2|cx|cy)="[-0-9.]+")+))re");
    const std::string text =
        between(svg, "id=\"view-" + std::to_string(view + 1) + "\"", "</g>\n</g>");
    Panel panel;
    for (std::sregex_iterator i(text.begin(), text.end(), element), end; i != end; ++i)
        panel.push_back({(*i)[1], (*i)[2] == "seen", (*i)[3]});
    return panel;
}

/// The panels of a text drawing, each a list of rows of glyphs.
std::vector<std::vector<std::vector<std::string>>> text_panels(const std::string& text, int views) {
    std::vector<std::vector<std::vector<std::string>>> panels(static_cast<std::size_t>(views));
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("│")) continue;
        std::vector<std::string> glyphs;
        for (const char c : line) {
            if ((static_cast<unsigned char>(c) & 0xc0U) != 0x80U) glyphs.emplace_back();
            glyphs.back() += c;
        }
        const std::size_t width = (glyphs.size() + 1) / panels.size();
        REQUIRE(glyphs.size() + 1 == width * panels.size());
        CHECK(glyphs.size() <= 98);
        for (std::size_t view = 0; view < panels.size(); ++view) {
            const auto begin = glyphs.begin() + static_cast<std::ptrdiff_t>(view * width);
            CHECK(*begin == "│");
            CHECK(*(begin + static_cast<std::ptrdiff_t>(width) - 2) == "│");
            panels[view].emplace_back(begin + 1, begin + static_cast<std::ptrdiff_t>(width) - 2);
        }
    }
    return panels;
}

std::map<std::string, int> glyph_counts(const std::vector<std::vector<std::string>>& panel) {
    std::map<std::string, int> counts;
    for (const auto& row : panel)
        for (const std::string& glyph : row)
            ++counts[glyph];
    return counts;
}

/// The text without tags of their own, balanced and properly nested.
void check_well_formed(const std::string& svg) {
    std::vector<std::string> open;
    static const std::regex tag(R"re(<(/?)([a-z]+)((?: [A-Za-z0-9:-]+="[^"<>&]*")*)(/?)>)re");
    std::size_t end = svg.find("?>\n") + 3;
    for (std::sregex_iterator i(svg.begin() + static_cast<std::ptrdiff_t>(end), svg.end(), tag),
         last;
         i != last; ++i) {
        const auto position = static_cast<std::size_t>(i->position()) + svg.find("?>\n") + 3;
        CHECK(svg.substr(end, position - end).find_first_of("<>&") == std::string::npos);
        end = position + static_cast<std::size_t>(i->length());
        if ((*i)[1] == "/") {
            REQUIRE(!open.empty());
            CHECK(open.back() == (*i)[2]);
            open.pop_back();
        } else if ((*i)[4] != "/") {
            open.push_back((*i)[2]);
        }
    }
    CHECK(open.empty());
    CHECK(svg.substr(end) == "\n");
}

int count_points(const Features& problem) {
    return static_cast<int>(std::ranges::count_if(problem, &Feature::has_point));
}

} // namespace

TEST_CASE("every panel of the SVG shows each point and line once, as seen or as not seen") {
    for (const std::string& text : drawn_problems) {
        CAPTURE(text);
        const Features problem = parse_features(text);
        const std::string svg = draw_svg(problem);
        int lines = 0;
        for (const Feature& feature : problem)
            lines += feature.lines;
        for (int view = 0; view < problem.front().views(); ++view) {
            int seen_points = 0;
            int seen_lines = 0;
            for (const Feature& feature : problem) {
                seen_points += feature.sees_point(view) ? 1 : 0;
                for (int line = 0; line < feature.lines; ++line)
                    seen_lines += feature.sees_line(view, line) ? 1 : 0;
            }
            Panel panel = svg_panel(svg, view);
            const auto count = [&](const std::string& name, bool seen) {
                return std::ranges::count_if(
                    panel, [&](const Element& e) { return e.name == name && e.seen == seen; });
            };
            CHECK(count("circle", true) == seen_points);
            CHECK(count("circle", false) == count_points(problem) - seen_points);
            CHECK(count("line", true) == seen_lines);
            CHECK(count("line", false) == lines - seen_lines);
            // No two elements at the same place, and the same places in every view.
            Panel first = svg_panel(svg, 0);
            std::ranges::sort(panel, {}, &Element::place);
            std::ranges::sort(first, {}, &Element::place);
            CHECK(std::ranges::adjacent_find(panel, {}, &Element::place) == panel.end());
            CHECK(std::ranges::equal(panel, first, {}, &Element::place, &Element::place));
        }
    }
}

TEST_CASE("the SVG is well formed, has a title, and no number has more than two decimals") {
    for (const std::string& text : drawn_problems) {
        CAPTURE(text);
        const std::string svg = draw_svg(parse_features(text));
        check_well_formed(svg);
        CHECK(between(svg, "<title>", "</title>") == "<title>" + notation(parse_features(text)));
        CHECK(svg.find("<desc>") != std::string::npos);
        CHECK(!std::regex_search(svg, std::regex(R"([0-9]\.[0-9]{3}|[0-9]e[-+]?[0-9]|nan|inf)")));
        CHECK(std::regex_search(svg, std::regex("viewBox=\"0 0 [0-9.]+ [0-9.]+\"")));
    }
}

TEST_CASE("every panel of the text shows each seen line by its letter and each point once") {
    for (const std::string& text : drawn_problems) {
        CAPTURE(text);
        const Features problem = parse_features(text);
        const int views = problem.front().views();
        const auto panels = text_panels(draw_text(problem), views);
        for (int view = 0; view < views; ++view) {
            std::map<std::string, int> expected;
            for (const Feature& feature : problem) {
                if (feature.has_point) ++expected[feature.sees_point(view) ? "●" : "○"];
                for (int line = 0; line < feature.lines; ++line)
                    if (feature.sees_line(view, line))
                        ++expected[std::string(1, static_cast<char>('a' + line))];
            }
            auto counts = glyph_counts(panels[static_cast<std::size_t>(view)]);
            for (const char* stroke : {" ", "·", "─", "│", "╱", "╲"})
                counts.erase(stroke);
            CHECK(counts == expected);
        }
    }
}

TEST_CASE("what a view does not see is dotted in the text, at the place where others see it") {
    const auto kind = [](const std::string& glyph) {
        if (glyph == "●" || glyph == "○") return 'P';
        const std::array<std::string, 5> strokes{"·", "─", "│", "╱", "╲"};
        return std::ranges::find(strokes, glyph) != strokes.end() ? '-' : ' ';
    };
    for (const std::string& text : drawn_problems) {
        CAPTURE(text);
        const Features problem = parse_features(text);
        const auto panels = text_panels(draw_text(problem), problem.front().views());
        for (const auto& panel : panels)
            for (std::size_t row = 0; row < panel.size(); ++row)
                CHECK(std::ranges::equal(panel[row], panels[0][row], {}, kind, kind));
        // If the views see all, there are no dots; if they see nothing, there are no strokes.
        Features all = problem;
        Features nothing = problem;
        for (std::size_t i = 0; i < problem.size(); ++i)
            for (std::size_t view = 0; view < panels.size(); ++view) {
                all[i].sights[view] = {problem[i].has_point, (1U << problem[i].lines) - 1};
                nothing[i].sights[view] = {};
            }
        for (const auto& panel : text_panels(draw_text(all), static_cast<int>(panels.size()))) {
            CHECK(glyph_counts(panel).count("·") == 0);
            CHECK(glyph_counts(panel).count("○") == 0);
        }
        for (const auto& panel : text_panels(draw_text(nothing), static_cast<int>(panels.size())))
            for (const auto& [glyph, count] : glyph_counts(panel))
                CHECK((glyph == "·" || glyph == "○" || glyph == " "));
    }
}

TEST_CASE("relabeling the views permutes the panels, and pictures do not vary") {
    const std::array<int, 3> rotation{1, 2, 0};
    for (const std::string& text : drawn_problems) {
        CAPTURE(text);
        const Features problem = parse_features(text);
        CHECK(draw_svg(problem) == draw_svg(problem));
        CHECK(draw_text(problem) == draw_text(problem));
        if (problem.front().views() != 3) continue;
        Features relabeled;
        for (const Feature& feature : problem)
            relabeled.push_back(relabel_views(feature, rotation));
        const std::string before = draw_svg(problem);
        const std::string after = draw_svg(relabeled);
        const auto text_before = text_panels(draw_text(problem), 3);
        const auto text_after = text_panels(draw_text(relabeled), 3);
        for (std::size_t view = 0; view < 3; ++view) {
            const int from = rotation[view];
            CHECK(svg_panel(after, static_cast<int>(view)) == svg_panel(before, from));
            CHECK(text_after[view] == text_before[static_cast<std::size_t>(from)]);
        }
    }
}

TEST_CASE("features neither overlap nor leave the panel, and no three points are collinear") {
    for (std::size_t size = 1; size <= 20; ++size) {
        CAPTURE(size);
        const std::string svg = draw_svg(parse_features(std::to_string(size) + "*Pab/Pab/Pab"));
        std::smatch frame;
        REQUIRE(std::regex_search(svg, frame,
                                  std::regex("<rect width=\"([0-9.]+)\" height=\"([0-9.]+)\"")));
        struct Disc {
            double x, y, radius;
        };
        std::vector<Disc> discs;
        static const std::regex line(
            "x1=\"([-0-9.]+)\" y1=\"([-0-9.]+)\" x2=\"([-0-9.]+)\" y2=\"([-0-9.]+)\"");
        for (const Element& element : svg_panel(svg, 0)) {
            std::smatch match;
            if (!std::regex_search(element.place, match, line)) continue;
            const double x1 = std::stod(match[1]), y1 = std::stod(match[2]);
            const double x2 = std::stod(match[3]), y2 = std::stod(match[4]);
            discs.push_back({(x1 + x2) / 2, (y1 + y2) / 2, std::hypot(x2 - x1, y2 - y1) / 2});
        }
        REQUIRE(discs.size() == 2 * size); // two lines a feature
        for (std::size_t i = 0; i < discs.size(); i += 2) {
            CHECK(discs[i].x - discs[i].radius > 0);
            CHECK(discs[i].y - discs[i].radius > 0);
            CHECK(discs[i].x + discs[i].radius < std::stod(frame[1]));
            CHECK(discs[i].y + discs[i].radius < std::stod(frame[2]));
            for (std::size_t j = 0; j < i; j += 2) {
                const double dx = discs[i].x - discs[j].x, dy = discs[i].y - discs[j].y;
                CHECK(std::hypot(dx, dy) > discs[i].radius + discs[j].radius);
                for (std::size_t k = 0; k < j; k += 2)
                    CHECK(std::abs(dx * (discs[k].y - discs[j].y) -
                                   dy * (discs[k].x - discs[j].x)) > 2);
            }
        }
    }
}
