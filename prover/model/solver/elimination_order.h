// In which order the unknowns of linear equations are eliminated, where most coefficients are 0.
#pragma once

#include "prover/model/solver/tracking/tracked_program.h"

#include <vector>

namespace plprove::model {

/// The steps of an elimination, and the rows and columns that these refer to.
struct EliminationOrder {
    std::vector<EliminationStep> steps; ///< one for each unknown
    std::vector<int> indices;
};

/// Takes the unknown next that makes fewest products (after H. M. Markowitz, Management Science
/// 1957). `nonzero` says of a square matrix where it may have other numbers than 0: each row in a
/// step counts as having all columns of the step, so any of these rows may have the pivot (A.
/// George, E. Ng, SIAM J. Sci. Stat. Comput. 1987). Of a singular matrix some pivots are 0.
EliminationOrder elimination_order(std::vector<std::vector<bool>> nonzero);

} // namespace plprove::model
