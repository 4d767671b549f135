// Scenes with three points on a line, modulo the prime 2^61 - 1, as in sections 1 and 4 of
// proofs/collinear_points_more_views.md: pins of the points, cameras, and what these see.
#pragma once

#include "checker/algebra/modular.h"

#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace proofs {

using checker::Residue;
using Pair = std::array<Residue, 2>;

inline Residue dot(const Pair& a, const Pair& b) {
    return a[0] * b[0] + a[1] * b[1];
}

inline Residue area(const Pair& a, const Pair& b) {
    return a[0] * b[1] - a[1] * b[0];
}

/// Random numbers other than 0, the same in each run.
class Numbers {
public:
    explicit Numbers(std::uint64_t seed) : engine(seed) {}
    Residue operator()() { return Residue::of(engine() % (checker::modulus - 1) + 1); }
    Pair pair() { return {(*this)(), (*this)()}; }

private:
    std::mt19937_64 engine;
};

/// phi_1, phi_2 and phi_3 = phi_1 + phi_2, by number 0, 1, 2 of the point.
inline Pair form(std::size_t point) {
    const Residue zero{}, one{1};
    return std::array{Pair{one, zero}, Pair{zero, one}, Pair{one, one}}[point];
}

/// A line through the point of this number, (s : w) in the plane of all of them.
struct Pin {
    std::size_t point = 0;
    Residue s;
    Pair w;
};

/// (r, w) is seen at (r + C w, c w).
struct Camera {
    std::array<Pair, 2> C; // by rows
    Pair c;

    Pair apply(const Pair& w) const { return {dot(C[0], w), dot(C[1], w)}; }

    /// The number t of equation (1).
    Residue image(const Pin& pin) const {
        return (pin.s + dot(form(pin.point), apply(pin.w))) * dot(c, pin.w).inverse();
    }
};

/// So many pins at the three points.
using PinCounts = std::array<std::size_t, 3>;

inline std::vector<Pin> random_pins(const PinCounts& counts, Numbers& random) {
    std::vector<Pin> pins;
    for (std::size_t point = 0; point < counts.size(); ++point)
        for (std::size_t n = 0; n < counts[point]; ++n)
            pins.push_back({point, random(), random.pair()});
    return pins;
}

inline Camera random_camera(Numbers& random) {
    return {{random.pair(), random.pair()}, random.pair()};
}

/// A camera that sees the free line W on the image line (a, -1).
inline Camera random_camera_of_line(const Pair& a, Numbers& random) {
    Camera camera = random_camera(random);
    for (std::size_t k = 0; k < 2; ++k)
        camera.c[k] = a[0] * camera.C[0][k] + a[1] * camera.C[1][k];
    return camera;
}

/// beta and beta' with phi_point = beta phi_3 + beta' a.
inline Pair in_terms_of(const Pair& a, std::size_t point) {
    const Pair phi = form(point), third = form(2);
    const Residue scale = (third[0] * a[1] - third[1] * a[0]).inverse();
    return {(phi[0] * a[1] - phi[1] * a[0]) * scale,
            (third[0] * phi[1] - third[1] * phi[0]) * scale};
}

} // namespace proofs
