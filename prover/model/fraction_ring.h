// A program over fractions of polynomials modulo q, as an elimination reads it (certs/FORMAT.md,
// section 16): their denominators are products of divisors, and their degrees in groups of
// variables are those for arbitrary data.
#pragma once

#include "prover/model/evaluation.h"
#include "prover/model/monomial.h"

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace plprove::model {

/// Degrees, one a group of variables.
using Degrees = std::vector<int>;

struct Fraction {
    Polynomial numerator;
    std::map<std::size_t, int>
        denominator;                ///< exponents of divisors, by the number of the division
    std::optional<Degrees> degrees; ///< of the numerator; nothing for a 0 that has none
    bool foreign = false;           ///< whether an unknown occurs that is no variable
};

class FractionRing {
public:
    using Scalar = Fraction;

    FractionRing(std::span<const Modular> data, std::size_t groups)
        : data_(data), groups_(groups) {}

    Fraction constant(int value) const;
    static Fraction zero() { return {}; }
    Fraction datum(std::size_t index) const;
    static Fraction unknown(std::size_t index);
    static Fraction variable(std::size_t index, const Degrees& degrees);
    Fraction sum(const Fraction& a, const Fraction& b) const { return combined(a, b, false); }
    Fraction difference(const Fraction& a, const Fraction& b) const { return combined(a, b, true); }
    Fraction product(const Fraction& a, const Fraction& b) const;
    Fraction quotient(const Fraction& a, const Fraction& b, const Operation& operation);

private:
    /// A divisor of a division that has data or variables.
    struct Divisor {
        Polynomial numerator;
        std::optional<Degrees> degrees;
    };

    Fraction combined(const Fraction& a, const Fraction& b, bool subtract) const;
    /// The fraction times the divisors that this product of divisors has more of.
    Fraction expanded(const Fraction& a, const std::map<std::size_t, int>& denominator) const;

    std::span<const Modular> data_;
    std::size_t groups_;
    std::map<std::size_t, Divisor> divisors_;
};

} // namespace plprove::model
