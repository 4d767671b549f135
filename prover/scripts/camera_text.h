// The cameras of a point-line problem as statements of a model.
#pragma once

#include "prover/problem/problem.h"
#include "prover/scripts/model_text.h"

#include <string>

namespace plprove {

/// Adds the unknowns of the cameras, camera 1 being [I | 0], and `let` statements for the others,
/// [M2 | t2] and so on: `M` is the letter that is returned. Throws BadInput for a kind of cameras
/// that is not one of the nine of certs/FORMAT.md, section 13.
std::string append_cameras(ModelText& text, const Problem& problem);

/// Adds `count` statements: solutions with the same cameras are one.
void append_counts(ModelText& text, const Problem& problem);

} // namespace plprove
