// Essential matrices of two views that several solutions of a fibre share: loops of images keep
// these solutions together (proofs/shared_matrices.md).
#pragma once

#include "prover/model/quotient.h"

namespace plprove {

/// The polynomial modulo q whose roots are the values of a number that the essential matrix of two
/// views determines: of the two views that have fewest such matrices. 1 if no two views have at
/// most half as many as there are solutions, or if the number is not defined at all of them. The
/// unknowns are the camera coordinates.
model::Univariate shared_matrices(const model::Solutions& solutions);

} // namespace plprove
