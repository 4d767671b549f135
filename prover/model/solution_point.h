// Solutions of a model modulo q, one at a time. One that is regular is a fibre of one point, which
// shows that the model is minimal. Solutions are found by solving for data, where the equations are
// linear in some of them.
#pragma once

#include "prover/model/fibre.h"

namespace plprove::model {

/// The ranks of the Jacobian by the unknowns at random solutions: evidence where all are too small.
struct RanksSeen {
    std::size_t solutions = 0; ///< at how many: those that are rational in random residues
    std::size_t rank = 0;      ///< the largest of these
    /// The rank at generic solutions is larger than this one with a probability of at most
    /// 10^-digits.
    std::size_t digits = 0;
};

struct PointSearch {
    std::optional<Fibre> fibre; ///< one regular solution
    RanksSeen seen;             ///< if there is none
};

/// Random unknowns and data, corrected in as many scalars of data as there are equations, so that
/// the equations hold; where the conditions hold and the Jacobian by the unknowns is regular.
/// Gives up after some hundred random choices of these scalars.
PointSearch find_solution_point(const Model& model, const Program& program);

} // namespace plprove::model
