// The equations of a model in the variables of some groups, for eliminations.
#pragma once

#include "prover/model/data_polynomial.h"
#include "prover/model/elimination.h"
#include "prover/model/fraction_ring.h"

namespace plprove::model {

/// The names of each group. A name may be in several, and several times in one: each time adds 1 to
/// the degree that its variables have there.
using Grouping = std::vector<std::vector<std::string>>;

/// The variables of a grouping, by their degrees in its groups.
struct GroupedVariables {
    std::vector<Degrees> units; ///< of each variable: how many times each group has it
    std::size_t groups = 0;

    Degrees degrees_of(const Monomial& monomial) const;
    /// All monomials up to these degrees in ascending lexicographic order; nothing if they are more
    /// than `most`.
    std::optional<std::vector<Monomial>> monomials(const Degrees& degrees, std::size_t most) const;
};

/// An equation that speaks of variables alone.
template <class Coefficient>
struct GroupedEquation {
    std::size_t number = 0; ///< among the equations of the model, from 1
    PolynomialOver<Coefficient> polynomial;
    Degrees degrees;
};

template <class Coefficient>
struct GroupedSystem {
    GroupedVariables variables;
    std::vector<GroupedEquation<Coefficient>> equations;
};

bool at_most(const Degrees& a, const Degrees& b);
Degrees sum_of(const Degrees& a, const Degrees& b);

/// The groupings worth trying: one group of all names, or a group a name; two groups, which may
/// have names in common; and those where a name is several times in a group.
std::vector<Grouping> groupings(const Program& program);
std::vector<Grouping> groupings_in_two(const Program& program);
std::vector<Grouping> weighted_groupings(const Program& program);

/// The array of an unknown or of a `let` outside of loops.
const Array& array_of(const Program& program, const std::string& name);

/// The names whose scalars are the variables, in the order of these.
std::vector<std::string> variable_names(const Grouping& grouping);

/// The equations of the model with these data. Nothing if a value that counts has unknowns that are
/// no variables, or if there are too many variables.
template <class Coefficient>
std::optional<GroupedSystem<Coefficient>>
grouped_system(const Program& program, std::span<const Coefficient> data, const Grouping& grouping);

extern template std::optional<GroupedSystem<Modular>>
grouped_system(const Program&, std::span<const Modular>, const Grouping&);
extern template std::optional<GroupedSystem<DataPolynomial>>
grouped_system(const Program&, std::span<const DataPolynomial>, const Grouping&);

} // namespace plprove::model
