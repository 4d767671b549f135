// Models that are written from other texts.
#pragma once

#include <string>

namespace plprove {

/// The text of a model of this point-line problem, as people name it (prover/problem/spec.h), with
/// its number of solutions where that is certified. Throws NotationError, and BadInput where the
/// problem is too large for a model.
std::string model_of_problem(const std::string& spec);

/// The text, if it is a model. Throws BadInput if it is none: as it was written well, `what` was
/// too large for one.
std::string well_formed(std::string text, const std::string& what);

} // namespace plprove
