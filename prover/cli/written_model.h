// Models that are written from other texts.
#pragma once

#include <string>

namespace plprove {

/// The text of a model of this point-line problem, as people name it (prover/problem/spec.h), with
/// its number of solutions where that is certified. Throws NotationError, and BadInput where the
/// problem is too large for a model.
std::string model_of_problem(const std::string& spec);

/// The text of a model of the equations of a program for Macaulay2, HomotopyContinuation.jl or
/// Matlab that was read from this path. Throws ModelError where it is not understood, and BadInput
/// where it is none, or too large for a model.
std::string model_of_program(const std::string& program, const std::string& path);

} // namespace plprove
