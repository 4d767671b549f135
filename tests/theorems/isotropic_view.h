// A camera modulo a prime with a focal length of its own, in isotropic coordinates (+, -, 3): those
// of a vector x are x_1 + i x_2, x_1 - i x_2 and x_3.
#pragma once

#include "tests/theorems/residue_vectors.h"

#include <array>

namespace isotropic {

using checker::Residue;
using residue_vectors::random_vector;
using residue_vectors::Vector;

constexpr Residue two{2};

/// Twice the bilinear form of x_+ x_- + w x_3^2.
inline Residue form(const Vector& x, const Vector& y, Residue w) {
    return x[0] * y[1] + x[1] * y[0] + two * w * x[2] * y[2];
}

/// A camera with a random focal length, place, and rotation: two reflections.
class View {
public:
    explicit View(proofs::Residues& random)
        : focal_(random.next()),
          place_(random_vector(random)), mirrors_{random_vector(random), random_vector(random)} {}

    Residue w() const { return focal_ * focal_; }

    Vector direction(Vector x) const {
        for (const Vector& normal : mirrors_) {
            const Residue factor = two * form(x, normal, {1}) * form(normal, normal, {1}).inverse();
            x = minus(x, times(factor, normal));
        }
        return {focal_ * x[0], focal_ * x[1], x[2]};
    }

    Vector point(const Vector& x) const { return plus(direction(x), place_); }

    Vector line(const Vector& x, const Vector& y) const { return cross(point(x), point(y)); }

private:
    Residue focal_;
    Vector place_;
    std::array<Vector, 2> mirrors_;
};

} // namespace isotropic
