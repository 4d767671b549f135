// The ring of polynomial functions modulo q on a variety of rotations: on all of SO(3), or on the
// rotations that take a given direction into a given plane, a product of two circles. A function
// is a sum of normal monomials (certs/FORMAT.md, section 10).
#pragma once

#include "prover/geometry/flint.h"

#include <array>
#include <map>
#include <vector>

namespace plprove::bounds {

using Monomial = std::array<int, 4>;
using Polynomial = std::map<Monomial, Residue>;

/// Degree on all rotations: (half the degree in the quaternion, 0); on the product: the degrees in
/// the coordinates of the two circles.
using BiDegree = std::array<int, 2>;

constexpr bool at_most(const BiDegree& a, const BiDegree& b) {
    return a[0] <= b[0] && a[1] <= b[1];
}

constexpr BiDegree sum(const BiDegree& a, const BiDegree& b) {
    return {a[0] + b[0], a[1] + b[1]};
}

enum class Rotations {
    all,         // coordinates (w, x, y, z), w² + x² + y² + z² = 1, even degree
    two_circles, // (c, s, c', s'), c² + s² = 1 = c'² + s'²: about the third, then the first axis
};

class RotationRing {
public:
    explicit RotationRing(Rotations rotations) : rotations_(rotations) {}

    /// The degree of the entries of the rotation matrix, and of the generators of the ring.
    BiDegree unit() const { return {1, rotations_ == Rotations::all ? 0 : 1}; }

    BiDegree degree(const Monomial& monomial) const;

    /// The normal monomials of degree at most `bound`, in lexicographic order of the exponents.
    std::vector<Monomial> monomials(const BiDegree& bound) const;

    /// The rotation matrix, row by row.
    std::array<Polynomial, 9> matrix() const;

    Polynomial product(const Polynomial& a, const Polynomial& b) const;

private:
    void add_normal(Polynomial& total, Monomial monomial, Residue coefficient) const;

    Rotations rotations_;
};

Polynomial constant(std::int64_t value);
Polynomial scaled(const Polynomial& a, std::int64_t factor);
Polynomial sum(const Polynomial& a, const Polynomial& b);
Polynomial difference(const Polynomial& a, const Polynomial& b);

} // namespace plprove::bounds
