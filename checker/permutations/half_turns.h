// Half-turns: a view that sees one point and little else turns about its ray to it
// (proofs/half_turns.md).
#pragma once

#include "checker/problem/classes.h"

#include <optional>

namespace checker {
/// The two other views, beside one that the theorem is about: a pair of solutions has the same
/// essential matrix of these. None if there is no such view.
std::optional<Views> views_beside_half_turns(const Signature& signature);
} // namespace checker
