// What is where in the panels of a picture, whatever it is written in.
//
// Features are placed in general position, no three points on a line, each at the same place in
// every panel. Lengths are in units; a unit is meant as a point of a printed page. x goes to
// the right, y down.
#pragma once

#include "prover/drawing/drawing.h"

#include <variant>
#include <vector>

namespace plprove {

/// Black, grey, and red for what a reader is to look at.
enum class Ink { seen, unseen, highlighted };

struct Stroke {
    double x1 = 0, y1 = 0, x2 = 0, y2 = 0;
    double width = 0;
    Ink ink{};
};

struct Dot {
    double x = 0, y = 0, radius = 0;
    bool rim = false; ///< a white one, which tells the dot from lines through it
    Ink ink{};
};

/// The letter of a line, centred.
struct Letter {
    double x = 0, y = 0, size = 0;
    char letter = 'a';
};

using Element = std::variant<Stroke, Dot, Letter>;

/// The elements of one view, the undermost first.
using Panel = std::vector<Element>;

struct Picture {
    double width = 0, height = 0; ///< of each panel
    std::vector<Panel> panels;
};

inline constexpr double panel_gap = 14;

Picture picture_of(const Features& problem, Highlight highlight);

/// At most two decimals, whatever the locale.
std::string number(double value);

} // namespace plprove
