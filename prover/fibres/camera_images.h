// The camera equations of a certificate with integer images (certs/FORMAT.md, section 9).
#pragma once

#include "prover/three_views/degree.h"
#include "prover/three_views/integer_vectors.h"

namespace plprove {

struct CameraImages {
    CameraSystem system;
    std::vector<IntegerVector> vectors; ///< one for each image vector of the system
};

/// Of images with these free vectors.
CameraImages camera_images(const CameraSystem& system, const std::vector<IntegerVector>& free);
CameraImages camera_images(const DegreeCertificate& certificate);

} // namespace plprove
