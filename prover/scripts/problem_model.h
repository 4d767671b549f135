// A point-line problem as a model (docs/models.md): cameras, points, lines and what the views see.
//
// Points and lines are in the frame of camera 1. A point that view 1 sees lies on a ray that is
// known, so its inverse depth is its only unknown; a line that view 1 sees joins points of two such
// rays. What two views alone see of a point is an epipolar constraint, without an unknown. What two
// views alone see of a line says nothing of the cameras, and is left out.
#pragma once

#include "prover/problem/problem.h"

#include <string>

namespace plprove {

/// The text of the model. `claimed` is the number of solutions that a theorem gives, 0 if none
/// does. Throws BadInput where the kind of cameras has no model.
std::string problem_model(const Problem& problem, int claimed);

/// The same problem, with the same degree, whose view 1 sees most points: two views in the place of
/// each other. So the model has fewer unknowns, and paths lose less.
Problem best_view_first(Problem problem);

} // namespace plprove
