// The equations of the cameras and depths: that a point of space, which view 1 shows, is on an
// image line of another view.
#pragma once

#include "prover/many_views/moving_images.h"

namespace plprove::many_views {

/// l · (M x + depth t) = 0 for the camera [M | t] of the view. The depth is a linear function of
/// the unknown depths.
template <class Scalar>
struct Incidence {
    std::size_t view = 0; ///< counted from 0; never view 0
    Vector<Scalar> l, x;
    std::vector<Scalar> depth; ///< the factors of the unknown depths
};

/// How many depths are unknown: one of each free point and of each line with one point, two of each
/// line without points.
std::size_t unknown_depths(const Problem& problem);

/// All equations: one for each unknown depth and camera parameter if the problem is balanced.
/// Assumes that all views see everything.
std::vector<Incidence<Moving>> incidences(const Problem& problem, const Images<Moving>& images);
std::vector<Incidence<Polynomial>> incidences(const Problem& problem,
                                              const Images<Polynomial>& images);

} // namespace plprove::many_views
