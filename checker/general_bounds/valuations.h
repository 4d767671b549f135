// How many solutions a system has whose coefficients are series, by their valuations alone
// (proofs/upright_views.md, section 2).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace checker {
/// The exponents of the unknowns of a monomial, none of them 0.
using Exponents = std::map<std::size_t, int>;

/// A Laurent polynomial, by the valuations of its coefficients.
using Valued = std::map<Exponents, std::int64_t>;

/// Sum and product of polynomials none of whose leading coefficients cancel.
Valued operator+(const Valued& f, const Valued& g);
Valued operator*(const Valued& f, const Valued& g);

/// What a polynomial is to its system: one of its equations, a linear relation that some others may
/// imply, or a consequence, which does no more than to shorten the search.
enum class Role { equation, relation, consequence };

struct Condition {
    Role role = Role::equation;
    Valued polynomial{};
};

/// How many solutions there are, if at each point where every minimum is attained twice there is a
/// regular system of binomials; else none. Time: some microseconds for each of up to a million
/// regions, so seconds. Earlier conditions should cut more.
std::optional<std::size_t> solutions_by_valuations(std::size_t unknowns,
                                                   const std::vector<Condition>& system);
} // namespace checker
