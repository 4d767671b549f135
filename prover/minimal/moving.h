// Vectors modulo q that move: a value, and how it changes with each unknown.
#pragma once

#include "prover/geometry/flint.h"

#include <array>
#include <span>
#include <vector>

namespace plprove {

using ResidueVector = std::array<Residue, 3>;

inline const nmod_t residue_field = modulus_context();

inline Residue times(Residue a, Residue b) {
    return nmod_mul(a, b, residue_field);
}
inline Residue plus(Residue a, Residue b) {
    return nmod_add(a, b, residue_field);
}
inline Residue minus(Residue a, Residue b) {
    return nmod_sub(a, b, residue_field);
}
inline Residue dot(const ResidueVector& a, const ResidueVector& b) {
    return plus(plus(times(a[0], b[0]), times(a[1], b[1])), times(a[2], b[2]));
}
inline ResidueVector cross(const ResidueVector& a, const ResidueVector& b) {
    return {minus(times(a[1], b[2]), times(a[2], b[1])),
            minus(times(a[2], b[0]), times(a[0], b[2])),
            minus(times(a[0], b[1]), times(a[1], b[0]))};
}

/// A vector of space and its derivatives by the scene unknowns.
struct Moving {
    ResidueVector value{};
    std::vector<ResidueVector> derivative;

    explicit Moving(int unknowns) : derivative(static_cast<std::size_t>(unknowns)) {}
};

/// a + s b, where s does not move.
inline Moving plus_multiple(const Moving& a, Residue s, const Moving& b) {
    Moving sum = a;
    for (std::size_t i = 0; i < 3; ++i)
        sum.value[i] = plus(sum.value[i], times(s, b.value[i]));
    for (std::size_t k = 0; k < sum.derivative.size(); ++k)
        for (std::size_t i = 0; i < 3; ++i)
            sum.derivative[k][i] = plus(sum.derivative[k][i], times(s, b.derivative[k][i]));
    return sum;
}

inline Moving difference(const Moving& a, const Moving& b) {
    return plus_multiple(a, residue(-1), b);
}

/// A 3 x 4 matrix row by row.
using CameraMatrix = std::array<std::array<Residue, 4>, 3>;

/// A camera and its derivatives by its own unknowns.
struct MovingCamera {
    CameraMatrix matrix{};
    std::vector<CameraMatrix> derivative;
};

} // namespace plprove
