// An elimination of a model (certs/FORMAT.md, section 16): multiples of the equations whose matrix
// expresses all monomials up to some degrees by those of a basis. It shows that the model has at
// most as many solutions, for generic data, as the basis has monomials.
#pragma once

#include "prover/model/program.h"
#include "prover/model/random_residues.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace plprove::model {

/// Names whose scalars are variables, and the degree up to which the columns go in them.
struct Group {
    int degree = 0;
    std::vector<std::string> names;
};

struct Elimination {
    std::vector<Modular> data;
    std::vector<Group> groups;
    std::vector<std::size_t> basis; ///< numbers of columns, from 1, ascending
    /// For equations, by number from 1, the numbers of the columns that they are multiplied by.
    std::vector<std::pair<std::size_t, std::vector<std::size_t>>> rows;
    Modular minor; ///< of all columns but the basis
};

/// The elimination with as small a basis as was found; the search ends at a basis of `target`
/// monomials, or with 0, which says that no lower bound is known, before large matrices. Nothing if
/// none was found.
std::optional<Elimination> find_elimination(const Model& model, const Program& program,
                                            std::size_t target);

} // namespace plprove::model
