// Certificates of camera-degrees (certs/FORMAT.md, section 9): solutions carried over to integer
// images, and written with as few digits as the checker needs to find them again.
#pragma once

#include "prover/degree/degree.h"
#include "prover/degree/monodromy.h"

namespace plprove {

/// Follows the first `most` solutions that `monodromy` has found to random integer images. The
/// certificate shows all that arrive, each real solution and pair once, ordered by their
/// coordinates.
DegreeCertificate certify_degree(const CameraSystem& system, Monodromy& monodromy, int most,
                                 Random& random);

} // namespace plprove
