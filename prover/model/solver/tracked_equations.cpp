#include "prover/model/solver/tracked_equations.h"

#include "prover/model/solver/schedule.h"

namespace plprove::model {

namespace {

EliminationOrder order_for(const Expressions& nodes,
                           const std::vector<DerivedEquation>& equations) {
    std::vector<std::vector<bool>> nonzero;
    for (const DerivedEquation& equation : equations) {
        std::vector<bool>& row = nonzero.emplace_back();
        for (const NodeIndex derivative : equation.by_unknown)
            row.push_back(derivative != nodes.zero());
    }
    return elimination_order(std::move(nonzero));
}

} // namespace

TrackedEquations::TrackedEquations(const Program& program) {
    Expressions nodes;
    const std::vector<DerivedEquation> equations = derived_equations(program, nodes);
    order_ = order_for(nodes, equations);
    Schedule schedule = scheduled(nodes, equations);
    constants_ = std::move(schedule.constants);
    data_ = std::move(schedule.data);
    operations_ = std::move(schedule.operations);
    copies_ = std::move(schedule.copies);
    zeros_ = std::move(schedule.zeros);
    program_.unknowns = static_cast<int>(program.unknowns);
    program_.places = schedule.places;
    program_.constants = static_cast<int>(constants_.size());
    program_.constant = constants_.data();
    program_.data = static_cast<int>(data_.size());
    program_.datum = data_.data();
    program_.operations_at_rest = schedule.operations_at_rest;
    program_.operations = static_cast<int>(operations_.size());
    program_.operation = operations_.data();
    program_.copies_at_rest = schedule.copies_at_rest;
    program_.copies = static_cast<int>(copies_.size());
    program_.copy = copies_.data();
    program_.zeros = static_cast<int>(zeros_.size());
    program_.zero = zeros_.data();
    program_.step = order_.steps.data();
    program_.index = order_.indices.data();
}

} // namespace plprove::model
