#include "prover/drawing/caption.h"
#include "prover/drawing/picture.h"

#include <algorithm>

namespace plprove {

namespace {

constexpr double margin = 4;
constexpr double title_height = 18;
constexpr double line_height = 14;
constexpr double character_width = 6; // of the caption's 10 unit type, which is fixed-width

std::string colour(Ink ink) {
    switch (ink) {
    case Ink::seen:
        return "#000";
    case Ink::unseen:
        return "#bbb";
    case Ink::highlighted:
        return "#d00";
    }
    return {};
}

std::string attribute(const std::string& name, const std::string& value) {
    return " " + name + "=\"" + value + "\"";
}
std::string attribute(const std::string& name, double value) {
    return attribute(name, number(value));
}

std::string class_of(Ink ink) {
    return attribute("class", ink == Ink::unseen ? "unseen" : "seen");
}

std::string text_element(double x, double y, const std::string& attributes,
                         const std::string& text) {
    return "<text" + attribute("x", x) + attribute("y", y) + " text-anchor=\"middle\"" +
           attributes + ">" + text + "</text>\n";
}

/// An element of a panel.
struct Writer {
    std::string operator()(const Stroke& line) const {
        return "<line" + class_of(line.ink) + attribute("x1", line.x1) + attribute("y1", line.y1) +
               attribute("x2", line.x2) + attribute("y2", line.y2) +
               attribute("stroke", colour(line.ink)) + attribute("stroke-width", line.width) +
               "/>\n";
    }
    std::string operator()(const Dot& dot) const {
        return "<circle" + class_of(dot.ink) + attribute("cx", dot.x) + attribute("cy", dot.y) +
               attribute("r", dot.radius) + attribute("fill", colour(dot.ink)) +
               (dot.rim ? " stroke=\"#fff\" stroke-width=\"0.8\"" : "") + "/>\n";
    }
    std::string operator()(const Letter& letter) const {
        // Lower case letters are a little less than half as high as the type.
        const double base = letter.y + 0.25 * letter.size;
        return text_element(letter.x, base,
                            attribute("class", "letter") + attribute("font-size", letter.size),
                            std::string(1, letter.letter));
    }
};

/// For readers who do not see the drawing.
std::string description(const Features& problem, Highlight highlight) {
    std::string text = "A point-line problem: " + describe(problem) +
                       ". Each panel is one view, with every feature at the same place. Points "
                       "and lines that the view sees are black, those that it does not see are "
                       "grey.";
    if (highlight == Highlight::five_points)
        text += " Five points that two views share are red in these views.";
    return "<title>" + notation(problem) + "</title>\n<desc>" + text + "</desc>\n";
}

/// The panel of a view, with its left edge at `left`.
std::string panel_element(const Picture& picture, std::size_t view, double left) {
    const std::string name = std::to_string(view + 1);
    const std::string place =
        "translate(" + number(left) + " " + number(margin + title_height) + ")";
    std::string svg =
        "<g" + attribute("id", "view-" + name) + attribute("transform", place) + ">\n";
    svg += text_element(picture.width / 2, -6, "", "view " + name);
    svg += "<rect" + attribute("width", picture.width) + attribute("height", picture.height) +
           " fill=\"none\" stroke=\"#808080\" stroke-width=\"0.6\"/>\n"
           "<g stroke-linecap=\"round\">\n";
    for (const Element& element : picture.panels[view])
        svg += std::visit(Writer{}, element);
    return svg + "</g>\n</g>\n";
}

double width_of(const std::vector<std::string>& lines) {
    std::size_t longest = 0;
    for (const std::string& line : lines)
        longest = std::max(longest, line.size());
    return character_width * static_cast<double>(longest);
}

std::string opening(double width, double height) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\"" +
           attribute("width", width) + attribute("height", height) +
           attribute("viewBox", "0 0 " + number(width) + " " + number(height)) +
           " style=\"background:#fff\">\n";
}

} // namespace

std::string draw_svg(const Features& problem, Highlight highlight) {
    const Picture picture = picture_of(problem, highlight);
    const auto views = static_cast<double>(picture.panels.size());
    const double panels_width = views * (picture.width + panel_gap) - panel_gap;
    const double caption_top = margin + title_height + picture.height + 6;
    const auto columns = static_cast<std::size_t>(panels_width / character_width);
    const std::vector<std::string> captions = caption(problem, columns);
    // A single summand may be wider than the panels.
    const double width = 2 * margin + std::max(panels_width, width_of(captions));
    const double left = (width - panels_width) / 2;
    const double height = caption_top + line_height * static_cast<double>(captions.size()) + margin;

    std::string svg = opening(width, height) + description(problem, highlight);
    svg += "<g font-family=\"Helvetica, Arial, sans-serif\" font-size=\"11\">\n";
    for (std::size_t view = 0; view < picture.panels.size(); ++view)
        svg += panel_element(picture, view,
                             left + static_cast<double>(view) * (picture.width + panel_gap));
    svg += "</g>\n<g font-family=\"Menlo, Consolas, 'DejaVu Sans Mono', monospace\" "
           "font-size=\"10\">\n";
    for (std::size_t i = 0; i < captions.size(); ++i)
        svg += text_element(width / 2, caption_top + line_height * (static_cast<double>(i) + 0.75),
                            "", captions[i]);
    return svg + "</g>\n</svg>\n";
}

} // namespace plprove
