// Values of a model (FORMAT.md, section 16): arrays of fractions over any ring. A ring has
// elements, and says how to calculate with them: `constant`, `add`, `subtract`, `multiply`, and
// `inverse` of what consists of constants.
#pragma once

#include "checker/file/complaint.h"

#include <cstdint>
#include <map>

namespace checker {
/// A fraction. Its denominator is a product of powers of divisors, by their numbers.
template <class Element> struct Fraction {
    Element numerator{};
    std::map<std::size_t, int> denominator{};
    bool is_constant = false; // made of constants and names of loops alone
};

/// Scalars in lexicographic order of the indices.
template <class Scalar> struct Array {
    std::vector<std::size_t> shape{};
    std::vector<Scalar> items{};

    bool is_scalar() const { return shape.empty(); }
    bool is_vector() const { return shape.size() == 1; }
    bool is_matrix() const { return shape.size() == 2; }
    const Scalar& at(std::size_t row, std::size_t column) const {
        return items[row * shape[1] + column];
    }
};

/// Thrown where shapes do not fit, or a name means nothing.
struct Senseless {
    std::string reason;
};

/// Calculates with fractions. Divisors are numbered as they come.
template <class Ring> class Fractions {
public:
    using Scalar = Fraction<typename Ring::Element>;

    explicit Fractions(Ring& ring) : ring_(ring) {}

    Scalar constant(int number) const {
        return {.numerator = ring_.constant(number), .is_constant = true};
    }

    Scalar add(const Scalar& a, const Scalar& b) const {
        Scalar sum{.denominator = a.denominator, .is_constant = a.is_constant && b.is_constant};
        for (const auto& [divisor, power] : b.denominator) {
            int& most = sum.denominator[divisor];
            most = std::max(most, power);
        }
        sum.numerator = ring_.add(expanded(a, sum.denominator), expanded(b, sum.denominator));
        return sum;
    }

    Scalar negative(const Scalar& a) const { return multiply(constant(-1), a); }

    Scalar subtract(const Scalar& a, const Scalar& b) const { return add(a, negative(b)); }

    Scalar multiply(const Scalar& a, const Scalar& b) const {
        Scalar product{.numerator = ring_.multiply(a.numerator, b.numerator),
                       .denominator = a.denominator,
                       .is_constant = a.is_constant && b.is_constant};
        for (const auto& [divisor, power] : b.denominator)
            product.denominator[divisor] += power;
        return product;
    }

    /// 1 / a, a division if a is no constant. Throws Refused if a is the constant 0.
    Scalar inverse(const Scalar& a) {
        if (a.is_constant) return {.numerator = ring_.inverse(a.numerator), .is_constant = true};
        Scalar result = constant(1);
        result.is_constant = false;
        for (const auto& [divisor, power] : a.denominator)
            for (int i = 0; i < power; ++i)
                result.numerator = ring_.multiply(result.numerator, divisors_[divisor]);
        result.denominator[divisors_.size()] = 1;
        divisors_.push_back(a.numerator);
        return result;
    }

    /// The numerators of the divisors.
    const std::vector<typename Ring::Element>& divisors() const { return divisors_; }

private:
    /// The numerator over a denominator that its own one divides.
    typename Ring::Element expanded(const Scalar& a,
                                    const std::map<std::size_t, int>& denominator) const {
        typename Ring::Element result = a.numerator;
        for (const auto& [divisor, power] : denominator) {
            const auto own = a.denominator.find(divisor);
            for (int i = own == a.denominator.end() ? 0 : own->second; i < power; ++i)
                result = ring_.multiply(result, divisors_[divisor]);
        }
        return result;
    }

    Ring& ring_;
    std::vector<typename Ring::Element> divisors_{};
};
} // namespace checker
