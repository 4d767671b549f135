// Scripts for computer algebra: the equations of a problem, ready to run without plprove.
//
// Both scripts hold the problem in the world formulation. Cameras are [R | t], the first [I | 0],
// the others with R the matrix of the quaternion (1, a, b, c), which is a rotation up to scale, and
// t; the first coordinate of t_2 is 1, as scale is free. A point has its three coordinates, a pin a
// direction (u, v, 1) and a free line a point (x, y, 1) and such a direction. For each image point
// or line the equations say that it is the image of the feature: there is one equation for each
// degree of freedom of the images. The images are those of a random scene, so that one solution is
// known.
//
// Any problem in two or three views will do, balanced or not. A script depends on the problem
// alone. Where no view sees anything there are no equations, and the script is a comment that says
// so.
#pragma once

#include "prover/problem/notation.h"

#include <string>

namespace plprove {

/// A script for Macaulay2: the ideal of the problem over a finite field, and the ranks of its
/// Jacobian at the known solution, with what follows from them.
std::string macaulay2_script(const Features& problem);

/// A script for Julia and HomotopyContinuation.jl (version 2): the system with the images as
/// parameters, a start pair, and how to solve it by monodromy.
std::string julia_script(const Features& problem);

} // namespace plprove
