// Lemmas F3 to F5 of proofs/fixed_forms.md, tried: a condition that does not hold is noticed.
#pragma once

#include "checker/general_bounds/fixed_forms.h"
#include "checker/general_bounds/resection.h"

namespace checker {
/// Throws Refused if some cubic form of these images does not vanish, as the lemmas say, at one
/// arbitrary scene of each kind of base scenes.
void try_lemmas(const Problem& problem, const SceneSystem& system, const BaseScenes& base,
                const SceneCoordinates& coordinates, const std::vector<Resection>& resections);
} // namespace checker
