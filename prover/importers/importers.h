// Systems of equations that are written in other languages, as models (docs/models.md).
//
// What is read are the statements that people write such systems with: variables, parameters,
// assignments, lists and matrices of polynomials. A program that computes its equations in another
// way is refused.
#pragma once

#include <string>
#include <string_view>

namespace plprove::importers {

/// The text of a model of the last ideal in a Macaulay2 program: the variables of its ring are
/// unknowns, those of the ring of coefficients are data. `source` is named in a comment. Throws
/// ModelError that says where something is not understood.
std::string from_macaulay2(std::string_view program, const std::string& source);

/// Likewise of the first `System` in a program for HomotopyContinuation.jl; its parameters are
/// data. One with the name `conditions` says what is not 0.
std::string from_julia(std::string_view program, const std::string& source);

/// Likewise of the first function in a Matlab program for generators of elimination templates, or
/// of a script: its first output, or `eqs` or `eq`, are the equations. What create_vars makes is
/// unknown, and so are symbols, or those that `unknown` names; random numbers and other symbols are
/// data.
std::string from_matlab(std::string_view program, const std::string& source);

/// The one of these that fits the ending of the file, .m2, .jl or .m, or else what the program has
/// in it. Throws BadInput if it is none.
std::string import_program(std::string_view program, const std::string& path);

} // namespace plprove::importers
