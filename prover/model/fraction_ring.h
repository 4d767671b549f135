// A program over fractions of polynomials, as an elimination reads it (certs/FORMAT.md, section
// 16): their denominators are products of divisors, and their degrees in groups of variables are
// those for arbitrary data.
#pragma once

#include "prover/model/evaluation.h"
#include "prover/model/polynomial.h"

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace plprove::model {

/// Degrees, one a group of variables.
using Degrees = std::vector<int>;

/// The sum of two degrees, or the larger one; nothing is that of a 0 that has none.
std::optional<Degrees> degrees_of_product(const std::optional<Degrees>& a,
                                          const std::optional<Degrees>& b);
std::optional<Degrees> degrees_of_sum(const std::optional<Degrees>& a,
                                      const std::optional<Degrees>& b);

/// Exponents of divisors, by the number of the division.
using Denominator = std::map<std::size_t, int>;

template <class Coefficient>
struct Fraction {
    PolynomialOver<Coefficient> numerator;
    Denominator denominator;
    std::optional<Degrees> degrees; ///< of the numerator; nothing for a 0 that has none
    bool foreign = false;           ///< whether an unknown occurs that is no variable
};

/// The data are coefficients. A coefficient without data and unknowns has an `inverse()`.
template <class Coefficient>
class FractionRing {
public:
    using Scalar = Fraction<Coefficient>;

    FractionRing(std::span<const Coefficient> data, std::size_t groups)
        : data_(data), groups_(groups) {}

    Scalar constant(int value) const { return of(Coefficient(value)); }
    static Scalar zero() { return {}; }
    Scalar datum(std::size_t index) const { return of(data_[index]); }
    static Scalar unknown(std::size_t /*index*/) { return {{}, {}, {}, true}; }
    static Scalar variable(std::size_t index, const Degrees& degrees) {
        return {PolynomialOver<Coefficient>::variable(index), {}, degrees, false};
    }
    Scalar sum(const Scalar& a, const Scalar& b) const { return combined(a, b, false); }
    Scalar difference(const Scalar& a, const Scalar& b) const { return combined(a, b, true); }
    Scalar product(const Scalar& a, const Scalar& b) const {
        if (a.foreign || b.foreign) return unknown(0);
        Scalar result{a.numerator * b.numerator, a.denominator,
                      degrees_of_product(a.degrees, b.degrees), false};
        for (const auto& [division, exponent] : b.denominator)
            result.denominator[division] += exponent;
        return result;
    }
    Scalar quotient(const Scalar& a, const Scalar& b, const Operation& operation);

private:
    /// A divisor of a division that has data or variables.
    struct Divisor {
        PolynomialOver<Coefficient> numerator;
        std::optional<Degrees> degrees;
    };

    Scalar of(const Coefficient& coefficient) const {
        return {PolynomialOver<Coefficient>(coefficient), {}, Degrees(groups_), false};
    }

    /// Multiplies the numerator by a divisor.
    void multiply(Scalar& a, std::size_t division) const {
        const Divisor& divisor = divisors_.at(division);
        a.numerator = a.numerator * divisor.numerator;
        a.degrees = degrees_of_product(a.degrees, divisor.degrees);
    }

    /// The fraction times the divisors that this product of divisors has more of.
    Scalar expanded(const Scalar& a, const Denominator& denominator) const {
        Scalar result = a;
        for (const auto& [division, exponent] : denominator)
            for (int& has = result.denominator[division]; has < exponent; ++has)
                multiply(result, division);
        return result;
    }

    Scalar combined(const Scalar& a, const Scalar& b, bool subtract) const {
        if (a.foreign || b.foreign) return unknown(0);
        Scalar result = expanded(a, b.denominator);
        const Scalar other = expanded(b, result.denominator);
        result.numerator =
            subtract ? result.numerator - other.numerator : result.numerator + other.numerator;
        result.degrees = degrees_of_sum(result.degrees, other.degrees);
        return result;
    }

    std::span<const Coefficient> data_;
    std::size_t groups_;
    std::map<std::size_t, Divisor> divisors_;
};

template <class Coefficient>
Fraction<Coefficient> FractionRing<Coefficient>::quotient(const Scalar& a, const Scalar& b,
                                                          const Operation& operation) {
    if (a.foreign || b.foreign) return unknown(0);
    // A divisor without data and unknowns is the same constant each time.
    if (!operation.by_variable) {
        if (b.numerator.is_zero())
            throw BadInput("the model divides by 0: state it without this division");
        return product(a, of(b.numerator.constant().inverse()));
    }
    divisors_.try_emplace(operation.division, Divisor{b.numerator, b.degrees});
    Scalar result = a;
    for (const auto& [division, exponent] : b.denominator)
        for (int i = 0; i < exponent; ++i)
            multiply(result, division);
    ++result.denominator[operation.division];
    return result;
}

} // namespace plprove::model
