// Polynomials modulo q and a polynomial g, with their derivatives by the unknowns: solutions whose
// coordinates are such polynomials stand for one solution a root of g (FORMAT.md, section 16).
#pragma once

#include "checker/algebra/dual.h"
#include "checker/file/complaint.h"

#include <optional>

namespace checker {
/// Coefficients, the constant one first.
using Polynomial = std::vector<Residue>;

/// The monic greatest common divisor; empty if both are 0.
Polynomial common_divisor(Polynomial a, Polynomial b);

/// F_q[t] / (g): elements have as many coefficients as the degree of g, which is at least 1.
class Extension {
public:
    /// g = t^N + the coefficients given, N of them.
    explicit Extension(Polynomial lower) : lower_(std::move(lower)) {}

    std::size_t degree() const { return lower_.size(); }
    Polynomial constant(Residue value) const;
    Polynomial multiply(const Polynomial& a, const Polynomial& b) const;
    /// The inverse; none if there is a common factor with g.
    std::optional<Polynomial> inverse(const Polynomial& a) const;
    /// The polynomial g itself.
    Polynomial modulus_polynomial() const;

private:
    Polynomial lower_;
};

Polynomial sum_of(Polynomial a, const Polynomial& b);
Polynomial difference_of(Polynomial a, const Polynomial& b);
bool is_zero(const Polynomial& a);

/// A ring for models: elements of the extension that know how they change with each unknown.
/// Changes that are left out are 0.
class DualExtension {
public:
    struct Element {
        Polynomial value{};
        std::vector<Polynomial> change{};
    };

    explicit DualExtension(const Extension& extension) : extension_(extension) {}

    Element constant(int number) const {
        return {extension_.constant(in_ring<Residue>(number)), {}};
    }
    /// The unknown of this number.
    Element unknown(Polynomial value, std::size_t number) const;
    Element add(const Element& a, const Element& b) const;
    Element multiply(const Element& a, const Element& b) const;
    /// Of a constant. Throws Refused if it is 0.
    Element inverse(const Element& a) const;

private:
    const Extension& extension_;
};

/// Whether the determinant has no common factor with g. Throws Refused if elimination would need a
/// pivot that has one.
bool is_regular(const Extension& extension, std::vector<std::vector<Polynomial>> matrix);
} // namespace checker
