// Unknowns in which equations are linear, modulo q and g, once the others are known.
#pragma once

#include "prover/fibres/univariate_field.h"

#include <functional>
#include <optional>
#include <vector>

namespace plprove {

/// The values of all equations at values of the unknowns.
using UnivariateEquations =
    std::function<std::vector<model::Univariate>(const std::vector<model::Univariate>&)>;

/// All unknowns, of which the first are given: the other `count` solve the equations, which are
/// linear in these. Nothing where they have no solution, or not one only at each root of g.
std::optional<std::vector<model::Univariate>>
with_linear_unknowns(const UnivariateField& field, std::vector<model::Univariate> first,
                     std::size_t count, const UnivariateEquations& equations);

} // namespace plprove
