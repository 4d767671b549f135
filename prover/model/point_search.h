// Looks for solutions of a model modulo a prime, one at a time: random unknowns and data, corrected
// in as many scalars of data as there are equations, so that the equations hold.
#pragma once

#include "prover/model/program.h"
#include "prover/model/random_residues.h"

#include <optional>
#include <vector>

namespace plprove::model {

/// Data and unknowns, by number.
template <class Number>
struct Point {
    std::vector<Number> data, unknowns;
};

/// The ranks of the Jacobian by the unknowns at random solutions: evidence where all are too small.
struct RanksSeen {
    std::size_t solutions = 0; ///< at how many: those that are rational in random residues
    std::size_t rank = 0;      ///< the largest of these
    /// The rank at generic solutions is larger than this one with a probability of at most
    /// 10^-digits.
    std::size_t digits = 0;
};

/// What a search has seen; `digits` of the ranks is not set.
template <class Number>
struct PointsSeen {
    std::optional<Point<Number>> best; ///< where the conditions hold, with the largest rank
    std::size_t rank_of_best = 0;      ///< of the Jacobian by the unknowns there
    RanksSeen ranks;
};

/// Modular or SmallModular.
template <class Number>
std::vector<Number> random_numbers(RandomResidues& random, std::size_t count);

/// Searches until the rank is as large as it can be: the smaller one of the numbers of equations
/// and of unknowns. Gives up after some hundred random choices of the scalars to correct. Numbers
/// are Modular or SmallModular.
template <class Number>
PointsSeen<Number> search_points(const Program& program, RandomResidues& random);

} // namespace plprove::model
