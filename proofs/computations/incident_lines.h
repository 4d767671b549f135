// The class of a free line that all views see, for the spaces of calibrated cameras.
#pragma once

#include "checker/algebra/modular.h"

#include <array>

namespace proofs {

/// The lines in P(V) that lie in three planes, one for each view: c_1^2 - c_2 of the difference of
/// the bundle of planes and V, with these Chern roots.
inline checker::Residue class_of_incident_line(const std::array<checker::Residue, 4>& space,
                                               const std::array<checker::Residue, 3>& planes) {
    checker::Residue c1, c2;
    for (const checker::Residue h : planes) {
        c2 = c2 + c1 * h;
        c1 = c1 + h;
    }
    for (const checker::Residue x : space) {
        c1 = c1 - x;
        c2 = c2 - c1 * x;
    }
    return c1 * c1 - c2;
}

} // namespace proofs
