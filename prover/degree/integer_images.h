// Certificates of camera-degrees (certs/FORMAT.md, section 9): solutions carried over to integer
// images, and written with as few digits as the checker needs to find them again.
#pragma once

#include "prover/degree/degree.h"
#include "prover/degree/monodromy.h"

namespace plprove {

/// Follows the first `most` solutions that `monodromy` has found to random integer images, on
/// another path again if fewer than `wanted` arrive. The certificate shows all that arrive, each
/// real solution and pair once, ordered by their coordinates.
DegreeCertificate certify_degree(const CameraSystem& system, Monodromy& monodromy, int most,
                                 int wanted, Random& random);

} // namespace plprove
