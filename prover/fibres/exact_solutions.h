// All solutions of equations at integer images, modulo q: from the few digits of a certificate to
// so many that they determine the solutions exactly.
#pragma once

#include "prover/model/lifting/refinement.h"
#include "prover/model/quotient.h"
#include "prover/monodromy/starting_values.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace plprove {

/// Random factors from -3 to 3 of so many camera coordinates.
std::vector<int> random_form(std::size_t count, std::uint64_t seed);

/// Whether a number that was computed with so many bits is 0, surely enough.
bool is_small(const model::BigComplex& x, long bits);

/// Of a solution with so many bits.
using IsDegenerate =
    std::function<bool(const model::DigitEquations::Point&, const model::ManyDigits&)>;

/// The solutions with these starting values; t is the sum of the first coordinates, each times its
/// factor in the form. Nothing where the form has one value at two solutions, one is degenerate, or
/// a step fails. `progress` is told how many bits the solutions have.
std::optional<model::Solutions> exact_solutions(
    const model::DigitEquations& equations, std::span<const StartingValues> starts,
    const std::vector<int>& form, const std::function<void(long)>& progress,
    const IsDegenerate& is_degenerate = [](const auto&, const auto&) { return false; });

} // namespace plprove
