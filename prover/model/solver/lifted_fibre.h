// Fibres of models whose Gröbner bases are too large: solutions for integer data by monodromy, to
// so many digits that they determine the rational coefficients of a fibre, which is then reduced
// modulo q.
#pragma once

#include "prover/model/fibre.h"

#include <functional>

namespace plprove::model {

struct LiftOptions {
    unsigned threads = 1;                              ///< the fibre is the same
    std::function<void(std::size_t found)> found = {}; ///< told how many solutions are found
    std::function<void(long bits)> bits = {};          ///< told how many bits they have
};

/// All solutions that are found, for small integer data. Assumes as many equations as unknowns.
FibreSearch lifted_fibre(const Model& model, const Program& program,
                         const LiftOptions& options = {});

} // namespace plprove::model
