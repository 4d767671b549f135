// One solution of a model modulo q: a fibre of one point, which shows that the model is minimal. It
// is found by solving for data, where the equations are linear in some of them.
#pragma once

#include "prover/model/fibre.h"

namespace plprove::model {

/// Random unknowns and data, corrected in as many scalars of data as there are equations, so that
/// the equations hold; where the conditions hold and the Jacobian by the unknowns is regular.
/// Nothing if some hundred random choices of these scalars do not lead to one.
std::optional<Fibre> find_solution_point(const Model& model, const Program& program);

} // namespace plprove::model
