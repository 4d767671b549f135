// Solutions of a fibre that have an essential matrix of two views in common: loops of images keep
// them together (proofs/shared_matrices.md).
#pragma once

#include "checker/fibres/fibre.h"
#include "checker/problem/features.h"

namespace checker {
/// Two views, and the polynomial modulo q of which each value of a number is a root that their
/// essential matrix determines, its highest term left out.
struct SharedMatrices {
    Views views = 0;
    Polynomial values{};
};

/// Of each two views that have at most half as many essential matrices as there are solutions, as
/// far as the number tells. The fibre is one of camera solutions, and holds.
std::vector<SharedMatrices> shared_matrices(const Fibre& fibre);
} // namespace checker
