// Scripts for computer algebra: the equations of a model (docs/models.md), ready to run without
// plprove. A script depends on the model's text alone. Both functions throw ModelError where it is
// not well-formed.
#pragma once

#include <string>

namespace plprove {

/// A script for Macaulay2: the ideal of the equations over a finite field, for random data that
/// follow from the model's words; the rank of the Jacobian at a solution, if one is found; and the
/// degree of the ideal without the zeros of conditions and denominators.
std::string macaulay2_script(const std::string& model);

/// A script for Julia and HomotopyContinuation.jl (version 2): the system with the data as
/// parameters, and how to find all solutions by monodromy.
std::string julia_script(const std::string& model);

} // namespace plprove
