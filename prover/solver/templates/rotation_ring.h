// The ring of polynomial functions modulo q on the rotations of a frame: on all of SO(3), or on the
// rotations that take a given direction into a given plane, a product of two circles. A function
// is a sum of normal monomials, in which w, or c and c', have exponents below 2.
#pragma once

#include "prover/geometry/flint.h"
#include "prover/solver/templates/frame.h"

#include <array>
#include <map>
#include <vector>

namespace plprove::templates {

/// Exponents of (w, x, y, z), w² + x² + y² + z² = 1, with even sum; in the other frames of
/// (c, s, c', s'), c² + s² = 1 = c'² + s'²: rotations about the third, then the first axis.
using Monomial = std::array<int, 4>;
using Polynomial = std::map<Monomial, Residue>;

class RotationFunction;

class RotationRing {
public:
    explicit RotationRing(Frame frame) : frame_(frame) {}

    /// The degree of the entries of the rotation, which generate the ring.
    BiDegree unit() const { return templates::unit(frame_); }
    BiDegree degree(const Monomial& monomial) const;

    /// The normal monomials of degree at most `bound`, in lexicographic order of the exponents.
    std::vector<Monomial> monomials(const BiDegree& bound) const;

    Polynomial product(const Polynomial& a, const Polynomial& b) const;

    /// The rotation matrix, row by row. The functions point to the ring.
    std::array<RotationFunction, 9> matrix() const;
    RotationFunction one() const;

private:
    void add_normal(Polynomial& total, Monomial monomial, Residue coefficient) const;

    Frame frame_;
};

/// A polynomial in formulas.
class RotationFunction {
public:
    RotationFunction(const RotationRing& ring, Polynomial polynomial)
        : ring_(&ring), polynomial_(std::move(polynomial)) {}

    const Polynomial& polynomial() const { return polynomial_; }

    friend RotationFunction operator+(const RotationFunction& a, const RotationFunction& b);
    friend RotationFunction operator-(const RotationFunction& a, const RotationFunction& b);
    friend RotationFunction operator*(const RotationFunction& a, const RotationFunction& b);
    friend RotationFunction operator*(const RotationFunction& a, std::int64_t factor);

private:
    const RotationRing* ring_;
    Polynomial polynomial_;
};

} // namespace plprove::templates
