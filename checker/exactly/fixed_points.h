// The points that the tori of the three views fix on the spaces of triples of calibrated cameras
// (proofs/three_views/): on the space A of quaternions there are 32, on the space M of triples 192,
// on the first blow-up 1,152. At each, the weights of all bundles are known, so an integral is a
// sum over these points (Atiyah and Bott). All is modulo q = 2^61 - 1, with generic weights +-y_v
// of the torus of view v on the spinors S_v.
#pragma once

#include "checker/algebra/modular.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace checker::exactly {
/// One number for each view; or for each pair of views, at the view that the pair lacks.
using Triple = std::array<Residue, 3>;

/// A fixed point of the first blow-up, the one of M in the loci Y_v where camera v has rank one.
struct FixedPoint {
    Residue weight{};           // by which the value of an integrand is multiplied
    std::array<Residue, 4> x{}; // the roots of V; those of H first, then that of V / H
    Triple h{};                 // of the line bundle of each view
    std::array<Triple, 3> w{};  // of the bundles that replace those of image vectors; of a null
                                // camera that of kappa^2 comes first
    Triple image{};       // of the subbundle of `w` that the image of a point spans; of a null
                          // camera also d_v, the class of its divisor: 0 if that is not here
    Triple exceptional{}; // E_v, the divisor over Y_v; 0 if that is not here

    /// F_v: on E_v, that the image line passes through kappa^2.
    Residue line_through_kappa(std::size_t view) const {
        return exceptional[view] * (h[view] - w[view][0]);
    }
};

/// A fixed point of the second blow-up, in the loci where the divisors of null cameras meet.
struct Chart {
    FixedPoint at{};
    Triple both{}; // G_uv, the divisor over two null views
};

/// The inverse of a number that generic weights do not let vanish.
Residue inverse(Residue x);

/// The 1,152 points of the first blow-up. The seed chooses the weights of the tori.
std::vector<FixedPoint> fixed_points(std::uint64_t seed);

/// Those of the second blow-up, with factors in their weights: sums over them are integrals. Where
/// two divisors of null cameras have the same class, the sum over the points above is the value at
/// t = 0 of a polynomial in t of degree 11 at most, which other classes d + t (...) have; it is
/// interpolated, so there are charts for each of twelve t.
std::vector<Chart> charts_of_second_blow_up(std::uint64_t seed);
} // namespace checker::exactly
