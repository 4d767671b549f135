// The equations of a model in the variables of some groups, for eliminations.
#pragma once

#include "prover/model/elimination.h"
#include "prover/model/fraction_ring.h"

namespace plprove::model {

/// The names of each group. A name may be in several.
using Grouping = std::vector<std::vector<std::string>>;

/// An equation that speaks of variables alone.
struct GroupedEquation {
    std::size_t number = 0; ///< among the equations of the model, from 1
    Polynomial polynomial;
    Degrees degrees;
};

struct GroupedSystem {
    std::vector<Degrees> units; ///< of each variable: 1 in the groups that have it, else 0
    std::size_t groups = 0;
    std::vector<GroupedEquation> equations;

    Degrees degrees_of(const Monomial& monomial) const;
    /// All monomials up to these degrees in ascending lexicographic order; nothing if they are more
    /// than `most`.
    std::optional<std::vector<Monomial>> monomials(const Degrees& degrees, std::size_t most) const;
};

bool at_most(const Degrees& a, const Degrees& b);
Degrees sum_of(const Degrees& a, const Degrees& b);

/// The groupings worth trying: without names in several groups, and with two groups that have
/// some in common.
std::vector<Grouping> groupings(const Program& program);
std::vector<Grouping> overlapping_groupings(const Program& program);

/// The equations of the model with these data. Nothing if a value that counts has unknowns that are
/// no variables, or if there are too many variables.
std::optional<GroupedSystem> grouped_system(const Program& program, std::span<const Modular> data,
                                            const Grouping& grouping);

} // namespace plprove::model
