// Views of cameras that know the vertical direction, modulo a prime.
#pragma once

#include "tests/theorems/residue_vectors.h"

namespace upright_view {

using checker::Residue;
using proofs::Residues;
using residue_vectors::random_vector;
using residue_vectors::Vector;

/// With second coordinate 1.
inline Vector upright(const Vector& x) {
    return times(x[1].inverse(), x);
}

/// A camera diag(1, 1, g) after a turn about the second axis. It sees the point Q at q.
class View {
public:
    explicit View(Residues& random) : g(random.next()), q(random_vector(random)) {
        const Residue u = random.next(), scale = (Residue{1} + u * u).inverse();
        cosine_ = (Residue{1} - u * u) * scale;
        sine_ = Residue{2} * u * scale;
    }

    Residue g;
    Vector q;

    /// The normal of the plane that is seen on an image line.
    Vector normal(const Vector& l) const { return turned_back({l[0], l[1], g * l[2]}); }

    /// The direction of the ray to Q.
    Vector ray() const { return turned_back({q[0], q[1], g.inverse() * q[2]}); }

    /// The image vector of a direction.
    Vector image(const Vector& x) const {
        return {x[0] * cosine_ + x[2] * sine_, x[1], g * (x[2] * cosine_ - x[0] * sine_)};
    }

    /// The image line through q with first coordinate x and second coordinate 1.
    Vector line(Residue x) const { return {x, {1}, -((x * q[0] + q[1]) * q[2].inverse())}; }

    /// The first coordinate of the line through q and an image vector.
    Residue place(const Vector& image_vector) const { return upright(cross(q, image_vector))[0]; }

private:
    Vector turned_back(const Vector& x) const {
        return {x[0] * cosine_ - x[2] * sine_, x[1], x[0] * sine_ + x[2] * cosine_};
    }

    Residue cosine_, sine_;
};

} // namespace upright_view
