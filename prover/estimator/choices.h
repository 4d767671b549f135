// Which minimal problems the matches of photos can be samples of, and which of these to take.
#pragma once

#include "prover/estimator/matches.h"
#include "prover/problem/feature.h"

#include <vector>

namespace plprove {

/// A problem that matches offer.
struct Choice {
    Features problem;
    int degree = 0;          ///< how many solutions it has
    double milliseconds = 0; ///< of one sample, on one core; about
    /// Milliseconds until a sample may be expected to lead to rotations within 5 degrees of the
    /// truth, where 30 % of the matches are wrong, and half a pixel of noise is on the others.
    double expected = 0;
    /// How far off the rotations of the best solution are, in degrees (median), if half a pixel of
    /// noise is on images with a focal length of 800 pixels.
    double error = 0;
};

/// The problems of a list of those that are solved fast, with their views in any order, for which
/// there are enough matches; the one expected to be fastest first.
std::vector<Choice> choices(const Matches& matches);

} // namespace plprove
