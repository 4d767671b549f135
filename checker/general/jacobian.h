// The Jacobian J of a problem in general, at the cameras and the scene of a record (FORMAT.md,
// section 13). All arithmetic is modulo q.
#pragma once

#include "checker/algebra/modular.h"
#include "checker/file/reader.h"
#include "checker/general/problem.h"

namespace checker::general {
/// Where a record places cameras and scene: its numbers as written.
struct Placement {
    std::vector<Numbers> cameras{}; // from the second: 7 numbers each if calibrated, else 12
    Numbers scene{};
};

/// How many numbers place the scene.
std::size_t scene_size(const Problem& problem);

/// det J modulo q, of a balanced problem.
Residue jacobian_determinant(const Problem& problem, const Placement& placement);
} // namespace checker::general
