#include "prover/model/solver/tracked_equations.h"

#include "prover/model/solver/schedule.h"

namespace plprove::model {

TrackedEquations::TrackedEquations(const Program& program) {
    Expressions nodes;
    const std::vector<DerivedEquation> equations = derived_equations(program, nodes);
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
}

} // namespace plprove::model
