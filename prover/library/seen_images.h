// From the images of the library to those of the solver.
#pragma once

#include "prover/library/pointline/solver.h"
#include "prover/problem/notation.h"
#include "prover/problem/problem.h"
#include "prover/solver/reconstruction.h"

namespace plprove {

/// Refuses images that are not what the problem says that the views see: throws BadInput.
void require_images(const Features& problem, const pointline::Images& images);

/// What takes normalised coordinates to the pixels of each view: nothing changes where there are no
/// intrinsics.
std::vector<Eigen::Matrix3d> calibration(const pointline::Images& images, int views);

struct MovedImages {
    SeenImages images;
    double moved = 0; ///< pixels, to make lines meet their points
};

/// The images in normalised coordinates, with lines that meet their points. Throws BadInput where
/// they are not what the problem says that the views see.
MovedImages seen_images(const Features& problem, const pointline::Images& images);

/// The same of a problem with shared lines, more views or uncalibrated cameras: a third point of a
/// line is moved onto the line through the first two.
MovedImages seen_images(const Problem& problem, const pointline::Images& images);

} // namespace plprove
