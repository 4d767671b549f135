#include "prover/model/fraction_ring.h"

#include <algorithm>

namespace plprove::model {

namespace {

std::optional<Degrees> sum_of(const std::optional<Degrees>& a, const std::optional<Degrees>& b) {
    if (!a || !b) return std::nullopt;
    Degrees result = *a;
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] += (*b)[i];
    return result;
}

std::optional<Degrees> larger_of(const std::optional<Degrees>& a, const std::optional<Degrees>& b) {
    if (!a) return b;
    if (!b) return a;
    Degrees result = *a;
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = std::max(result[i], (*b)[i]);
    return result;
}

} // namespace

Fraction FractionRing::constant(int value) const {
    return {Polynomial(Modular(value)), {}, Degrees(groups_), false};
}

Fraction FractionRing::datum(std::size_t index) const {
    return {Polynomial(data_[index]), {}, Degrees(groups_), false};
}

Fraction FractionRing::unknown(std::size_t /*index*/) {
    return {{}, {}, {}, true};
}

Fraction FractionRing::variable(std::size_t index, const Degrees& degrees) {
    return {Polynomial::variable(index), {}, degrees, false};
}

Fraction FractionRing::product(const Fraction& a, const Fraction& b) const {
    if (a.foreign || b.foreign) return unknown(0);
    Fraction result{a.numerator * b.numerator, a.denominator, sum_of(a.degrees, b.degrees), false};
    for (const auto& [division, exponent] : b.denominator)
        result.denominator[division] += exponent;
    return result;
}

Fraction FractionRing::expanded(const Fraction& a,
                                const std::map<std::size_t, int>& denominator) const {
    Fraction result = a;
    for (const auto& [division, exponent] : denominator) {
        const Divisor& divisor = divisors_.at(division);
        for (int& has = result.denominator[division]; has < exponent; ++has) {
            result.numerator = result.numerator * divisor.numerator;
            result.degrees = sum_of(result.degrees, divisor.degrees);
        }
    }
    return result;
}

Fraction FractionRing::combined(const Fraction& a, const Fraction& b, bool subtract) const {
    if (a.foreign || b.foreign) return unknown(0);
    Fraction result = expanded(a, b.denominator);
    const Fraction other = expanded(b, result.denominator);
    result.numerator =
        subtract ? result.numerator - other.numerator : result.numerator + other.numerator;
    result.degrees = larger_of(result.degrees, other.degrees);
    return result;
}

Fraction FractionRing::quotient(const Fraction& a, const Fraction& b, const Operation& operation) {
    if (a.foreign || b.foreign) return unknown(0);
    // A divisor without data and unknowns is the same constant each time.
    if (!operation.by_variable) {
        if (b.numerator.is_zero())
            throw BadInput("the model divides by 0: state it without this division");
        return product(a,
                       {Polynomial(b.numerator.constant().inverse()), {}, Degrees(groups_), false});
    }
    divisors_.try_emplace(operation.division, Divisor{b.numerator, b.degrees});
    Fraction result = a;
    for (const auto& [division, exponent] : b.denominator) {
        const Divisor& divisor = divisors_.at(division);
        for (int i = 0; i < exponent; ++i) {
            result.numerator = result.numerator * divisor.numerator;
            result.degrees = sum_of(result.degrees, divisor.degrees);
        }
    }
    ++result.denominator[operation.division];
    return result;
}

} // namespace plprove::model
