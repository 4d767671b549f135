// How large the degree of a polynomial may be: for the probability that one vanishes by chance.
#pragma once

#include "prover/model/program.h"

namespace plprove::model {

/// A bound for the sum of the total degrees of the equations in data and unknowns, as numerators of
/// fractions of which nothing is cancelled.
std::size_t sum_of_degrees(const Program& program);

} // namespace plprove::model
