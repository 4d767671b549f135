#include "prover/fibres/exact_solutions.h"

#include "prover/three_views/random.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plprove {

namespace {

using model::BigComplex;

/// The solutions, as a certificate has them.
std::vector<model::RefinedSolution> starting_points(std::span<const StartingValues> starts) {
    std::vector<model::RefinedSolution> result;
    for (const StartingValues& start : starts) {
        const std::size_t numbers = start.real ? 1 : 2;
        result.push_back({start.real, std::vector<BigComplex>(start.values.size() / numbers)});
        auto value = start.values.begin();
        for (BigComplex& x : result.back().coordinates) {
            arb_set_si(acb_realref(x.get()), *value++);
            if (!start.real) arb_set_si(acb_imagref(x.get()), *value++);
            acb_mul_2exp_si(x.get(), x.get(), -start.bits);
        }
    }
    return result;
}

/// The value of the form at each solution, and at conjugates.
std::vector<BigComplex> values_of(const std::vector<int>& form,
                                  const std::vector<model::RefinedSolution>& solutions,
                                  slong bits) {
    std::vector<BigComplex> result;
    for (const model::RefinedSolution& solution : solutions) {
        BigComplex value;
        for (std::size_t k = 0; k < form.size(); ++k)
            acb_addmul_si(value.get(), solution.coordinates[k].get(), form[k], bits);
        result.push_back(value);
        if (solution.real) continue;
        acb_conj(value.get(), value.get());
        result.push_back(value);
    }
    return result;
}

/// Whether the form has different values at all solutions: else no number of bits is enough.
bool separates(const std::vector<int>& form, const model::Refinement& refinement) {
    constexpr double near = 1e-6; // of a double, so that few pairs are compared
    const slong bits = refinement.bits();
    const model::ManyDigits digits{bits};
    std::vector<BigComplex> values = values_of(form, refinement.solutions(), bits);
    const auto real_part = [](const BigComplex& x) {
        return arf_get_d(arb_midref(acb_realref(x.get())), ARF_RND_NEAR);
    };
    std::ranges::sort(values, {}, real_part);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double last = real_part(values[i]) + near * (1 + std::abs(real_part(values[i])));
        for (std::size_t k = i + 1; k < values.size() && real_part(values[k]) <= last; ++k)
            if (is_small(digits.difference(values[i], values[k]), bits)) return false;
    }
    return true;
}

} // namespace

std::vector<std::vector<int>> forms_of(std::size_t count, std::uint64_t seed) {
    constexpr std::uint64_t stream = 0x666f726d;
    Random random(seed, stream);
    std::vector<std::vector<int>> result(count + 1, std::vector<int>(count));
    for (std::size_t k = 0; k < count; ++k) {
        result[k][k] = 1;
        result.back()[k] = static_cast<int>(random.bits() % 7) - 3;
    }
    return result;
}

bool is_small(const BigComplex& x, long bits) {
    mag_t size;
    mag_init(size);
    acb_get_mag(size, x.get());
    const bool result = mag_cmp_2exp_si(size, -bits / 2) <= 0;
    mag_clear(size);
    return result;
}

std::optional<model::ExactSolutions> exact_solutions(const model::DigitEquations& equations,
                                                     std::span<const StartingValues> starts,
                                                     std::vector<std::vector<int>> forms,
                                                     const std::function<void(long)>& progress,
                                                     const IsDegenerate& is_degenerate) {
    constexpr slong most_bits = 4'000'000;
    try {
        model::Refinement refinement(equations, starting_points(starts));
        const model::ManyDigits digits{refinement.bits()};
        for (const model::RefinedSolution& solution : refinement.solutions())
            if (is_degenerate(solution.coordinates, digits)) return std::nullopt;
        std::erase_if(forms, [&](const auto& form) { return !separates(form, refinement); });
        if (forms.empty()) return std::nullopt;
        return model::exact_solutions(std::move(refinement), forms, most_bits, progress);
    } catch (const std::runtime_error&) {
        return std::nullopt; // Newton's method fails near a singular solution
    }
}

} // namespace plprove
