// Letters, red points and LaTeX: what the pictures of a problem have beside points and lines.
#include "prover/drawing/picture.h"
#include "prover/minimal/obstruction.h"
#include "tests/support/drawn_problems.h"
#include "tests/support/text.h"

#include <algorithm>
#include <cmath>
#include <regex>

using namespace plprove;

namespace {

template <class Kind>
std::vector<Kind> elements(const Panel& panel) {
    std::vector<Kind> found;
    for (const Element& element : panel)
        if (const Kind* held = std::get_if<Kind>(&element)) found.push_back(*held);
    return found;
}

/// The distance of a letter from the line through a stroke.
double distance(const Letter& letter, const Stroke& line) {
    const double dx = line.x2 - line.x1;
    const double dy = line.y2 - line.y1;
    return std::abs(dx * (letter.y - line.y1) - dy * (letter.x - line.x1)) / std::hypot(dx, dy);
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t number = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1))
        ++number;
    return number;
}

/// All numbers with their decimals, in order.
std::vector<double> coordinates(const std::string& text) {
    static const std::regex number("-?[0-9]+(\\.[0-9]+)?");
    std::vector<double> found;
    for (std::sregex_iterator i(text.begin(), text.end(), number), end; i != end; ++i)
        found.push_back(std::stod(i->str()));
    return found;
}

std::size_t red_points(const Panel& panel) {
    return static_cast<std::size_t>(
        std::ranges::count(elements<Dot>(panel), Ink::highlighted, &Dot::ink));
}

} // namespace

TEST_CASE("each panel has the letters of the lines that its view sees, inside its frame") {
    for (const std::string& text : drawn_problems) {
        CAPTURE(text);
        const Features problem = parse_features(text);
        const Picture picture = picture_of(problem, Highlight::nothing);
        REQUIRE(picture.panels.size() == static_cast<std::size_t>(problem.front().views()));
        for (int view = 0; view < problem.front().views(); ++view) {
            std::string expected;
            for (const Feature& feature : problem)
                for (int line = 0; line < feature.lines; ++line)
                    if (feature.sees_line(view, line)) expected += static_cast<char>('a' + line);
            std::string found;
            for (const Letter& letter :
                 elements<Letter>(picture.panels[static_cast<std::size_t>(view)])) {
                found += letter.letter;
                CHECK(letter.x - letter.size / 2 > 0);
                CHECK(letter.y - letter.size / 2 > 0);
                CHECK(letter.x + letter.size / 2 < picture.width);
                CHECK(letter.y + letter.size / 2 < picture.height);
            }
            CHECK(found == expected);
        }
    }
}

TEST_CASE("a letter stands beside its own line, off the point and the other letters") {
    for (const int pins : {1, 2, 3, 7}) {
        CAPTURE(pins);
        const std::string view =
            "P" + std::string("abcdefg").substr(0, static_cast<std::size_t>(pins));
        const Features problem = parse_features(view + "/" + view);
        const Panel panel = picture_of(problem, Highlight::nothing).panels.front();
        const std::vector<Letter> letters = elements<Letter>(panel);
        const std::vector<Stroke> lines = elements<Stroke>(panel);
        const Dot dot = elements<Dot>(panel).front();
        REQUIRE(letters.size() == lines.size());
        for (std::size_t i = 0; i < letters.size(); ++i) {
            CHECK(distance(letters[i], lines[i]) > 1);
            CHECK(std::hypot(letters[i].x - dot.x, letters[i].y - dot.y) >
                  dot.radius + letters[i].size / 2);
            for (std::size_t j = 0; j < letters.size(); ++j) {
                if (j == i) continue;
                CHECK(distance(letters[i], lines[i]) < distance(letters[i], lines[j]));
                CHECK(std::hypot(letters[i].x - letters[j].x, letters[i].y - letters[j].y) >
                      letters[i].size);
            }
        }
    }
}

TEST_CASE("where two views share exactly five points, these are red in both, and nothing else") {
    for (const std::string& text : drawn_problems) {
        CAPTURE(text);
        const Features problem = parse_features(text);
        const Picture plain = picture_of(problem, Highlight::nothing);
        const Picture red = picture_of(problem, Highlight::five_points);
        const std::array<int, 3> shared = shared_points(problem);
        CHECK(has_five_points(problem) == (std::ranges::count(shared, 5) > 0));
        for (std::size_t view = 0; view < plain.panels.size(); ++view) {
            CHECK(red_points(plain.panels[view]) == 0);
            std::size_t pairs = 0;
            for (std::size_t i = 0; i < view_pairs.size(); ++i)
                if (shared[i] == 5)
                    pairs += std::ranges::count(view_pairs[i], static_cast<int>(view)) > 0;
            const std::size_t found = red_points(red.panels[view]);
            if (pairs < 2) CHECK(found == 5 * pairs);
            if (pairs == 2) CHECK(found > 5);
        }
        std::string svg = draw_svg(problem, Highlight::five_points);
        svg = std::regex_replace(svg, std::regex("#d00"), "#000");
        svg = std::regex_replace(svg, std::regex(" Five points[^.]*\\."), "");
        CHECK(svg == draw_svg(problem));
    }
}

TEST_CASE("LaTeX gets the same elements as the page, in balanced braces") {
    for (const std::string& text : drawn_problems) {
        CAPTURE(text);
        const Features problem = parse_features(text);
        const std::string tikz = draw_tikz(problem, Highlight::five_points);
        const std::string svg = draw_svg(problem, Highlight::five_points);
        CHECK(tikz.starts_with("% " + notation(problem) + "\n"));
        CHECK(tikz.ends_with("\\end{tikzpicture}\n"));
        CHECK(count(tikz, " -- ") == count(svg, "<line "));
        CHECK(count(tikz, " circle[") == count(svg, "<circle "));
        CHECK(count(tikz, "\\node[letter") == count(svg, "class=\"letter\""));
        CHECK(count(tikz, "\\path[five point") == count(svg, "#d00"));
        CHECK(count(tikz, "[unseen") == count(svg, "class=\"unseen\""));
        CHECK(count(tikz, "\\begin{scope}") == static_cast<std::size_t>(problem.front().views()));
        CHECK(count(tikz, "\\begin{scope}") == count(tikz, "\\end{scope}"));
        for (const char* pair : {"{}", "[]", "()"})
            CHECK(std::ranges::count(tikz, pair[0]) == std::ranges::count(tikz, pair[1]));
        // The first line of either.
        static const std::regex line("<line [^>]* x1=\"([^\"]*)\" y1=\"([^\"]*)\" x2=\"([^\"]*)\" "
                                     "y2=\"([^\"]*)\"");
        static const std::regex draw("\\] (\\([^)]*\\)) -- (\\([^)]*\\))");
        std::smatch a, b;
        if (!std::regex_search(svg, a, line)) continue;
        REQUIRE(std::regex_search(tikz, b, draw));
        CHECK(coordinates(b[1].str() + b[2].str()) ==
              coordinates(a[1].str() + " " + a[2].str() + " " + a[3].str() + " " + a[4].str()));
    }
}
