#include "checker/fibres/frobenius.h"

#include "checker/file/complaint.h"

#include <bit>
#include <numeric>

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

// The divisor of g and t^(q^n) - t is the product of the factors whose degree divides n. What is
// left when no two factors of degree n or more have room is one factor.
CycleType cycle_type_of(const Polynomial& lower) {
    const Extension extension(lower);
    const Polynomial t = extension.variable(), g = extension.modulus_polynomial();
    std::vector<Polynomial> images{extension.constant({1})}; // (t^k)^q
    const Polynomial image = frobenius_of_variable(extension);
    while (images.size() < extension.degree())
        images.push_back(extension.multiply(images.back(), image));
    CycleType lengths;
    Polynomial power = image; // t^(q^n)
    std::size_t left = extension.degree();
    for (std::size_t n = 1; left >= 2 * n; ++n) {
        std::size_t degree = common_divisor(g, difference_of(power, t)).size() - 1;
        for (const std::size_t length : lengths)
            if (n % length == 0) degree -= length;
        lengths.insert(lengths.end(), degree / n, n);
        left -= degree;
        Polynomial next = extension.constant({}); // q-th powers are taken term by term
        for (std::size_t k = 0; k < power.size(); ++k)
            for (std::size_t i = 0; i < next.size(); ++i)
                next[i] = next[i] + power[k] * images[k][i];
        power = std::move(next);
    }
    if (left > 0) lengths.push_back(left);
    return lengths;
}

std::uint64_t products_for_cycle_type(std::size_t degree) {
    return (5 * std::uint64_t{degree} + 300) * degree * degree;
}

/// Which sums parts of the cycles have.
static std::vector<bool> sums_of_parts(const CycleType& lengths, std::size_t solutions) {
    std::vector<bool> sums(solutions + 1);
    sums[0] = true;
    for (const std::size_t length : lengths)
        for (std::size_t sum = solutions; sum >= length; --sum)
            if (sums[sum - length]) sums[sum] = true;
    return sums;
}

std::string group_shown_by(const std::vector<CycleType>& cycle_types, std::size_t solutions) {
    std::vector<CycleType> whole; // permutations of all solutions
    for (const CycleType& lengths : cycle_types)
        if (std::accumulate(lengths.begin(), lengths.end(), std::size_t{0}) == solutions)
            whole.push_back(lengths);
    std::vector<bool> orbit(solutions + 1, true); // which sizes one may have
    bool has_cycle = false, is_even = false, is_odd = false;
    for (const CycleType& lengths : whole) {
        const std::vector<bool> sums = sums_of_parts(lengths, solutions);
        for (std::size_t size = 0; size <= solutions; ++size)
            orbit[size] = orbit[size] && sums[size];
        has_cycle |= std::ranges::any_of(lengths, [&](std::size_t length) {
            return 2 * length > solutions && length + 2 < solutions && is_prime(length);
        });
        ((solutions - lengths.size()) % 2 == 0 ? is_even : is_odd) = true;
    }
    const bool is_transitive = std::ranges::count(orbit, true) == 2; // 0 and all
    if (!is_transitive || !has_cycle) return {};
    return say(is_even && is_odd ? "S" : ">=A", solutions);
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
