// Polynomials modulo q, and modulo a polynomial g besides: a number of F_q[t] / (g) stands for one
// number at each root of g (FORMAT.md, section 16).
#pragma once

#include "checker/algebra/modular.h"

#include <optional>

namespace checker {
/// Coefficients, the constant one first.
using Polynomial = std::vector<Residue>;

Polynomial sum_of(Polynomial a, const Polynomial& b);        // a has at least as many coefficients
Polynomial difference_of(Polynomial a, const Polynomial& b); // likewise
Polynomial derivative(const Polynomial& a);
bool is_zero(const Polynomial& a);

/// The remainder of a by b, which is not 0. Neither ends with coefficients 0, nor the result.
Polynomial remainder(Polynomial a, const Polynomial& b);

/// The monic greatest common divisor; empty if both are 0.
Polynomial common_divisor(Polynomial a, Polynomial b);

/// F_q[t] / (g): elements have as many coefficients as the degree of g, from 1 to 10,000.
class Extension {
public:
    /// g = t^N + the coefficients given, N of them.
    explicit Extension(Polynomial lower);

    std::size_t degree() const { return lower_.size(); }
    Polynomial constant(Residue value) const;
    /// The number t.
    Polynomial variable() const;
    Polynomial multiply(const Polynomial& a, const Polynomial& b) const;
    /// The inverse; none if there is a common factor with g.
    std::optional<Polynomial> inverse(const Polynomial& a) const;
    /// Whether there is no common factor with g.
    bool is_unit(const Polynomial& a) const;
    /// The polynomial g itself.
    Polynomial modulus_polynomial() const;

private:
    Polynomial lower_;
    /// Of g with its coefficients reversed, as a power series: as many terms as the degree.
    Polynomial inverse_of_reversed_;
};

/// The minimal polynomial of x, its highest term left out, if it has at most this degree; else
/// empty. Its roots are the values of x at the roots of g.
Polynomial minimal_polynomial(const Extension& extension, const Polynomial& x, std::size_t most);

/// Whether the determinant has no common factor with g. Throws Refused if elimination would need a
/// pivot that has one.
bool is_regular(const Extension& extension, std::vector<std::vector<Polynomial>> matrix);
} // namespace checker
