// The equations of a model as nodes, and their derivatives by the unknowns and by time, when the
// data move.
//
// Derivatives are sums over the paths of the graph of operations, of products of the derivatives
// along a path. Vertices are eliminated one by one: the paths through one become edges from those
// before it to those after it. Where few paths lead through a vertex, it goes first (after H. M.
// Markowitz; see A. Griewank, A. Walther, Evaluating derivatives, 2008, chapters 9 and 10): so
// forward and reverse differentiation are mixed as the equations want it.
#pragma once

#include "prover/model/program.h"
#include "prover/model/solver/expressions.h"

namespace plprove::model {

/// An equation, as nodes.
struct DerivedEquation {
    NodeIndex value = 0;
    std::vector<NodeIndex> by_unknown; ///< one for each unknown
    NodeIndex by_time = 0;
};

/// Adds to `nodes` what these scalars of the program need. Returns their nodes.
std::vector<NodeIndex> nodes_of(const Program& program, const std::vector<ScalarIndex>& scalars,
                                Expressions& nodes);

/// Adds to `nodes` what the equations of the program and their derivatives need.
std::vector<DerivedEquation> derived_equations(const Program& program, Expressions& nodes);

} // namespace plprove::model
