// Random data of a model, with a solution.
#pragma once

#include "prover/model/solver/numeric_equations.h"
#include "prover/three_views/random.h"

namespace plprove::model {

/// One random number for each scalar.
Numbers random_numbers(std::size_t count, Field field, Random& random);

/// Real or complex unknowns and data whose equations hold, where the solution is regular and keeps
/// the conditions. Nothing if some attempts find none.
std::optional<SolvedData> random_solution(const Program& program, Field field, Random& random);

} // namespace plprove::model
