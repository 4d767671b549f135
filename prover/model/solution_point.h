// Solutions of a model modulo q, one at a time. One that is regular is a fibre of one point, which
// shows that the model is minimal. Solutions are found by solving for data, where the equations are
// linear in some of them.
#pragma once

#include "prover/model/fibre.h"
#include "prover/model/point_search.h"

namespace plprove::model {

struct PointSearch {
    std::optional<Fibre> fibre; ///< one regular solution
    RanksSeen seen;             ///< if there is none
};

/// Looks for a solution where the Jacobian by the unknowns, a square matrix, is regular.
PointSearch find_solution_point(const Model& model, const Program& program);

} // namespace plprove::model
