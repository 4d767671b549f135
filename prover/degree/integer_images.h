// Certificates of camera-degrees (certs/FORMAT.md, section 9): solutions carried over to integer
// images, and written with as few digits as the checker needs to find them again.
#pragma once

#include "prover/degree/degree.h"
#include "prover/degree/integer_vectors.h"
#include "prover/degree/monodromy.h"

namespace plprove {

/// Finds options.at_least solutions for random integer images by monodromy between these and the
/// images of a real scene nearby. The certificate shows those found, as that of certify_degree
/// does.
struct LowerBound {
    DegreeCertificate certificate;
    PathCounts counts;
};
LowerBound find_for_integer_images(const CameraSystem& system, const DegreeOptions& options,
                                   std::uint64_t stream);

/// The certificate for these images, one vector for each free vector of the system, with those of
/// the zeros, approximations in the standard chart, that are solutions; each real solution and pair
/// once, ordered by their coordinates. What the chart or 18 digits do not reach is left out.
DegreeCertificate certify_zeros(const CameraSystem& system,
                                const std::vector<IntegerVector>& vectors,
                                const std::vector<CameraPoint>& zeros);

/// Follows the first `most` solutions that `monodromy` has found to random integer images, on
/// another path again if fewer than `wanted` arrive. The certificate shows all that arrive, each
/// real solution and pair once, ordered by their coordinates.
DegreeCertificate certify_degree(const CameraSystem& system, Monodromy& monodromy, int most,
                                 int wanted, Random& random);

} // namespace plprove
