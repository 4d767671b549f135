// All solutions of equations at integer images, modulo q: from the few digits of a certificate to
// so many that they determine the solutions exactly.
#pragma once

#include "prover/model/lifting/eliminant.h"
#include "prover/monodromy/starting_values.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace plprove {

/// Each of so many unknowns alone; and their sum, with random factors from -3 to 3.
std::vector<std::vector<int>> forms_of(std::size_t count, std::uint64_t seed);

/// Whether a number that was computed with so many bits is 0, surely enough.
bool is_small(const model::BigComplex& x, long bits);

/// Of a solution with so many bits.
using IsDegenerate =
    std::function<bool(const model::DigitEquations::Point&, const model::ManyDigits&)>;

/// The solutions with these starting values, by the one of the forms that takes fewest bits.
/// Nothing where each form has one value at two solutions, a solution is degenerate, or a step
/// fails. `progress` is told how many bits the solutions have.
std::optional<model::ExactSolutions> exact_solutions(
    const model::DigitEquations& equations, std::span<const StartingValues> starts,
    std::vector<std::vector<int>> forms, const std::function<void(long)>& progress,
    const IsDegenerate& is_degenerate = [](const auto&, const auto&) { return false; });

} // namespace plprove
