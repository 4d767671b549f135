#include "prover/drawing/caption.h"
#include "prover/drawing/picture.h"

namespace plprove {

namespace {

std::string point(double x, double y) {
    return '(' + number(x) + ", " + number(y) + ')';
}

std::string style(Ink ink) {
    switch (ink) {
    case Ink::seen:
        return "seen";
    case Ink::unseen:
        return "unseen";
    case Ink::highlighted:
        return "five point";
    }
    return {};
}

/// An element of a panel as a command.
struct Writer {
    std::string operator()(const Stroke& line) const {
        return "\\draw[" + style(line.ink) + ", line width=" + number(line.width) + "pt] " +
               point(line.x1, line.y1) + " -- " + point(line.x2, line.y2) + ";\n";
    }
    std::string operator()(const Dot& dot) const {
        const std::string rim = dot.rim ? ", draw=white, line width=0.8pt" : "";
        return "\\path[" + style(dot.ink) + ", fill" + rim + "] " + point(dot.x, dot.y) +
               " circle[radius=" + number(dot.radius) + "pt];\n";
    }
    std::string operator()(const Letter& letter) const {
        const std::string size = number(letter.size);
        return "\\node[letter, font=\\fontsize{" + size + "}{" + size + "}\\selectfont] at " +
               point(letter.x, letter.y) + " {$" + letter.letter + "$};\n";
    }
};

} // namespace

std::string draw_tikz(const Features& problem, Highlight highlight) {
    const Picture picture = picture_of(problem, highlight);
    std::string text =
        "% " + notation(problem) + "\n% " + describe(problem) +
        "\n% Put \\usepackage{tikz} into the preamble, and \\input{THIS FILE} where the "
        "picture goes.\n"
        "% \\resizebox{\\linewidth}{!}{\\input{THIS FILE}} fits it to the width of the "
        "text.\n"
        "\\begin{tikzpicture}[x=1pt, y=-1pt, line cap=round,\n"
        "    seen/.style={black}, unseen/.style={black!27}, "
        "five point/.style={red},\n"
        "    frame/.style={black!50, line width=0.6pt}, "
        "letter/.style={inner sep=0pt}]\n";
    double left = 0;
    for (std::size_t view = 0; view < picture.panels.size(); ++view) {
        text += "\\begin{scope}[xshift=" + number(left) + "pt]\n";
        text += "\\node[above] at " + point(picture.width / 2, 0) + " {\\small view " +
                std::to_string(view + 1) + "};\n";
        text += "\\draw[frame] (0, 0) rectangle " + point(picture.width, picture.height) + ";\n";
        for (const Element& element : picture.panels[view])
            text += std::visit(Writer{}, element);
        text += "\\end{scope}\n";
        left += picture.width + panel_gap;
    }
    return text + "\\end{tikzpicture}\n";
}

} // namespace plprove
