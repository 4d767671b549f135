// Scripts for computer algebra: the equations of a model (docs/models.md), ready to run without
// plprove. A script depends on the model's statements alone.
#pragma once

#include "prover/model/program.h"

#include <string>

namespace plprove {

/// A script for Macaulay2: the ideal of the equations over a finite field, for random data that
/// follow from the model's words, without the zeros of conditions and denominators; and its degree.
std::string macaulay2_script(const model::Model& model, const model::Program& program);

/// A script for Julia and HomotopyContinuation.jl (version 2): the system with the data as
/// parameters, and how to find all solutions by monodromy.
std::string julia_script(const model::Model& model, const model::Program& program);

} // namespace plprove
