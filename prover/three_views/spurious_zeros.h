// Zeros of the camera equations that are no solutions of the problem.
//
// The equations use auxiliary lines and points (FORMAT.md, section 9). Solutions do not depend on
// them; but the equations have more zeros. Let views i and j see a point, and let view k see a pin
// of it. If the plane of the auxiliary line in view j contains the ray of view i and both centres,
// it contains the ray of view j, too: the epipolar equation and the incidence hold, whatever view k
// sees. These are two conditions in the place of two. So such zeros are isolated and regular, loops
// permute them among themselves. One path that jumps to one of them brings in all, and too many
// solutions would be counted.
#pragma once

#include "prover/three_views/images.h"

namespace plprove {

/// Tells spurious zeros from solutions, for some images: at a spurious zero the equations do not
/// hold any more with other auxiliary lines and points. (How close the cameras come to being
/// degenerate, scene.h, does not decide: solutions nearly as degenerate as rounding occur.)
class SpuriousZeros {
public:
    SpuriousZeros(const CameraSystem& system, const CameraChart& chart,
                  const std::vector<Complex3>& constants, const Images& images, Random& random);

    /// For each zero whether it is spurious. The zeros are approximations, which are made precise
    /// to about 32 digits first.
    std::vector<bool> among(const std::vector<CameraPoint>& zeros) const;

    /// For each zero the largest value of an equation with other auxiliary lines and points,
    /// relative to its value for unrelated images: rounding where the zero is a solution.
    std::vector<double> residuals(const std::vector<CameraPoint>& zeros) const;

private:
    TrackedSystem system_;
    std::vector<std::size_t> equations_; ///< that have an auxiliary vector
    TrackedImages at_rest_{};            ///< the images, then with other auxiliary vectors,
    TrackedImages turned_{}, scale_{};   ///< and unrelated images with these
};

} // namespace plprove
