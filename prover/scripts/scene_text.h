// The points and lines of a problem, and their images, as statements of a model.
#pragma once

#include "prover/problem/problem.h"
#include "prover/scripts/model_text.h"

#include <string>

namespace plprove {

/// Adds the data and unknowns of all features, and their equations, for cameras [M2 | t2] and so on
/// whose letter is `matrix`.
void append_scene(ModelText& text, const Problem& problem, const std::string& matrix);

} // namespace plprove
