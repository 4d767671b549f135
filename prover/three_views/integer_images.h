// Certificates of camera-degrees (certs/FORMAT.md, section 9): solutions carried over to integer
// images, and written with as few digits as the checker needs to find them again.
#pragma once

#include "prover/three_views/degree.h"
#include "prover/three_views/integer_vectors.h"
#include "prover/three_views/path_follower.h"

namespace plprove {

struct LowerBound {
    DegreeCertificate certificate;
    PathCounts counts;
    int lost = 0; ///< paths, for good
};

/// Finds `wanted` solutions for random integer images, with few digits if `small`, by monodromy
/// between these and the images of a real scene; else they are near this scene's. The certificate
/// shows those found, each real solution and pair once, ordered by their coordinates.
LowerBound find_for_integer_images(const CameraSystem& system, int wanted, std::uint64_t seed,
                                   std::uint64_t stream, bool small,
                                   const std::function<void(const MonodromyProgress&)>& progress);

/// The certificate for these images, one vector for each free vector of the system, with those of
/// the zeros, approximations in the standard chart, that are solutions. What the chart or 18 digits
/// do not reach is left out.
DegreeCertificate certify_zeros(const CameraSystem& system,
                                const std::vector<IntegerVector>& vectors,
                                const std::vector<CameraPoint>& zeros);

} // namespace plprove
