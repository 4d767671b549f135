// Pictures of a problem as in the figures of the paper: one panel per view, each feature at the
// same place in every panel, points as dots, pins as lines through their point, free lines, and
// what a view does not see faint.
//
// A picture depends on the problem alone, byte for byte. The functions take any problem: two or
// three views, up to 26 pins a point, reduced or not.
#pragma once

#include "prover/problem/notation.h"

#include <string>

namespace plprove {

/// The picture for a terminal, in UTF-8, under its notation and above a legend. A pin is drawn as a
/// ray that ends in its letter where the view sees it and is dotted where it does not. At most 98
/// columns wide; features that do not fit side by side go to further rows.
std::string draw_text(const Features& problem);

/// What a picture shows in red: nothing, or five points that two views share and that fix their
/// relative pose, in these two views.
enum class Highlight { nothing, five_points };

/// Whether two views share exactly five points.
bool has_five_points(const Features& problem);

/// The picture for a page: a standalone SVG 1.1 document with the notation as its caption, black
/// for what a view sees and grey for what it does not. Every element of the drawing is one `circle`
/// or `line` of class `seen` or `unseen`, or a `text` of class `letter` beside a line that the view
/// sees, in the group `view-1`, `view-2`, ... of its view.
std::string draw_svg(const Features& problem, Highlight highlight = Highlight::nothing);

/// The same picture, without its caption, as a `tikzpicture` for LaTeX. Its styles are `seen`,
/// `unseen`, `five point`, `frame` and `letter`.
std::string draw_tikz(const Features& problem, Highlight highlight = Highlight::nothing);

} // namespace plprove
