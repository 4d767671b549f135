// A header of C++ that solves one problem for any data, and needs nothing but the standard library:
// the equations of a model as code, solutions for random data, and what follows them to other data.
#pragma once

#include "prover/model/solver/model_solver.h"

#include <string>
#include <string_view>
#include <vector>

namespace plprove::generate {

/// What the header says and contains.
struct HeaderContents {
    std::string name;               ///< of the namespace: a name of C++
    std::string file;               ///< the name of the header
    std::vector<std::string> about; ///< lines: what the problem is, where it comes from
    std::vector<std::string> model; ///< its lines
    std::string solutions;          ///< a sentence: how many there are, and how that is known
    /// The numbers of cameras [R | t] up to a factor, which `let` statements or unknowns call R2
    /// and t2, and so on: solutions have them as rotations and translations.
    std::vector<int> cameras;
};

/// Whether a namespace may have this name.
bool is_name_of_namespace(const std::string& name);

/// The name of the model, or one like it that a namespace may have.
std::string name_of_namespace(const std::string& model);

/// The text of the header. The same for the same solver.
std::string header(const model::ModelSolver& solver, const HeaderContents& contents);

/// The lines of paths.h.
std::vector<std::string_view> lines_of_paths();

} // namespace plprove::generate
