#include "checker/fibres/frobenius.h"

#include <bit>

namespace checker {
static bool is_prime(std::size_t n) {
    for (std::size_t d = 2; d * d <= n; ++d)
        if (n % d == 0) return false;
    return n > 1;
}

/// a(b) modulo g, by Horner's rule.
static Polynomial composition(const Extension& extension, const Polynomial& a,
                              const Polynomial& b) {
    Polynomial sum = extension.constant({});
    for (std::size_t i = a.size(); i-- > 0;)
        sum = sum_of(extension.multiply(sum, b), {a[i]});
    return sum;
}

/// t^q modulo g.
static Polynomial frobenius_of_variable(const Extension& extension) {
    Polynomial product = extension.constant({1});
    for (int bit = 60; bit >= 0; --bit) {
        product = extension.multiply(product, product);
        if ((modulus >> bit) & 1) product = extension.multiply(product, extension.variable());
    }
    return product;
}

// An irreducible factor of degree k divides t^(q^k) - t. As the degree l is prime, and t^(q^l) = t,
// each has the degree l or 1; none has 1 if t^q - t has no common factor with g.
bool is_irreducible_of_prime_degree(const Polynomial& lower) {
    if (!is_prime(lower.size())) return false;
    const Extension extension(lower);
    const Polynomial t = extension.variable();
    const Polynomial image = frobenius_of_variable(extension);
    if (!extension.is_unit(difference_of(image, t))) return false;
    // t^(q^n) for the leading bits n of the degree: t^(q^(a + b)) is t^(q^a) at t^(q^b).
    Polynomial power = t;
    for (std::size_t bit = std::bit_floor(lower.size()); bit > 0; bit /= 2) {
        power = composition(extension, power, power);
        if ((lower.size() & bit) != 0) power = composition(extension, power, image);
    }
    return power == t;
}

/// The resultant of two polynomials, whose last coefficients are not 0.
static Residue resultant(Polynomial a, Polynomial b) {
    Residue result{1};
    while (b.size() > 1) {
        Polynomial rest = remainder(a, b);
        if (rest.empty()) return {};
        result = result * power(b.back(), a.size() - rest.size());
        if ((a.size() - 1) * (b.size() - 1) % 2 == 1) result = -result;
        a = std::exchange(b, std::move(rest));
    }
    return result * power(b.back(), a.size() - 1);
}

// By Stickelberger: the discriminant is a square if and only if the degree of g less the number of
// its factors is even.
bool frobenius_is_even(const Polynomial& lower) {
    const std::size_t degree = lower.size();
    Polynomial g = lower;
    g.push_back({1});
    const Residue resultant_with_derivative = resultant(g, derivative(g));
    const bool changes_sign = degree * (degree - 1) / 2 % 2 == 1;
    const Residue discriminant =
        changes_sign ? -resultant_with_derivative : resultant_with_derivative;
    return power(discriminant, (modulus - 1) / 2) == Residue{1};
}
} // namespace checker
