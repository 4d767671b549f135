// Certificates that given images have the solutions found (certs/FORMAT.md, section 9).
#pragma once

#include "prover/solver/images.h"
#include "prover/solver/plan.h"
#include "prover/solver/start.h"
#include "prover/three_views/degree.h"
#include "prover/three_views/integer_images.h"

namespace plprove {

/// Images of the class in integers of at most 18 digits, as a degree file has them.
struct IntegerImages {
    std::vector<IntegerVector> vectors; ///< one for each free vector of the system
    bool exact = true;                  ///< whether they are the given images
    double moved = 0;                   ///< if not: the largest angle to a given one, in radians
};

/// The integer vectors that are proportional to the images, where 18 digits are enough; elsewhere
/// some nearby, which are off by 1e-18.
IntegerImages integer_images(const SolvePlan& plan, const CameraSystem& system,
                             const ConsistentImages& images);

/// Images of five points in two views as integers of nine digits, as a file of solutions has them
/// (certs/FORMAT.md, section 14).
struct FivePointImages {
    static constexpr int digits = 9;
    std::vector<std::vector<int>> views; ///< three numbers for each point
    bool exact = true;                   ///< as in IntegerImages
    double moved = 0;
};

/// The five points that the plan solves. Where nine digits are not enough, those nearby are off by
/// some 1e-9.
FivePointImages five_point_images(const SolvePlan& plan, const ConsistentImages& images);

/// The same as unit vectors, as the solver takes them.
std::vector<Eigen::Vector3d> unit_vectors(const IntegerImages& images);

/// The certificate that these images have these solutions, approximate zeros in the standard chart.
DegreeCertificate certify_images(const Start& start, const CameraSystem& system,
                                 const IntegerImages& images,
                                 const std::vector<CameraPoint>& zeros);

} // namespace plprove
