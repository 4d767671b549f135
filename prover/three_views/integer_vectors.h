// Integer vectors for the images of a certificate (certs/FORMAT.md, section 9).
#pragma once

#include "prover/three_views/images.h"

#include <array>
#include <vector>

namespace plprove {

using IntegerVector = std::array<std::int64_t, 3>;

/// Vectors of integers from -90 to 90, one for each free vector of the system, whose images are
/// neighbours of real ones. Of many choices it takes the one farthest from degenerate images: the
/// fewest solutions are ill-conditioned there.
std::vector<IntegerVector> vectors_near(const CameraSystem& system, const Images& images,
                                        Random& random);

/// Vectors of small integers: what is computed from them has few digits, too.
std::vector<IntegerVector> small_vectors(const CameraSystem& system, Random& random);

/// Images of the same directions, and of length 1 as those that paths come from.
Images unit_images(const std::vector<IntegerVector>& vectors);

} // namespace plprove
