// Monomials in at most 32 variables.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace plprove::model {

/// The computation is beyond the prover's own limits. The message says which.
class TooLarge : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

inline constexpr std::size_t most_variables = 32;

/// The exponents of a product of variables, all 0 at first.
struct Monomial {
    std::array<std::uint8_t, most_variables> exponents{};

    auto operator<=>(const Monomial&) const = default; ///< lexicographic
    int degree() const;
    bool divides(const Monomial& other) const;
    /// Throws TooLarge if an exponent is more than 255.
    friend Monomial operator*(const Monomial& a, const Monomial& b);
    /// Assumes that b divides a.
    friend Monomial operator/(const Monomial& a, const Monomial& b);
};

/// Throws TooLarge if there is no such variable.
Monomial variable_monomial(std::size_t variable);
Monomial least_common_multiple(const Monomial& a, const Monomial& b);

/// Whether a is less than b in the graded reverse lexicographic order.
bool grevlex_less(const Monomial& a, const Monomial& b);

struct HashOfMonomial {
    std::size_t operator()(const Monomial& monomial) const;
};

} // namespace plprove::model
