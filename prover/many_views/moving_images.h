// What views see of a problem with complete visibility, in complex numbers that may move.
//
// Camera 1 is [I | 0], so view 1 shows where in space something is, up to a depth: the image vector
// x stands for the point (x, depth) in homogeneous coordinates. A camera [M | t] of another view
// sees it at M x + depth t.
#pragma once

#include "prover/many_views/polynomial.h"
#include "prover/problem/problem.h"

#include <array>
#include <complex>
#include <vector>

namespace plprove::many_views {

using Complex = std::complex<double>;

/// A number and its derivative by time.
struct Moving {
    Complex value, speed;

    Moving() = default;
    /// At rest, unless a speed is given.
    explicit Moving(const Complex& number, const Complex& derivative = 0)
        : value(number), speed(derivative) {}

    friend Moving operator+(const Moving& a, const Moving& b) {
        return Moving(a.value + b.value, a.speed + b.speed);
    }
    friend Moving operator-(const Moving& a, const Moving& b) {
        return Moving(a.value - b.value, a.speed - b.speed);
    }
    friend Moving operator*(const Moving& a, const Moving& b) {
        return Moving(a.value * b.value, a.value * b.speed + a.speed * b.value);
    }
};

template <class Scalar>
using Vector = std::array<Scalar, 3>;

/// What one view sees. Lines with two points or more need no entry.
template <class Scalar>
struct ViewImages {
    /// Of a free point its image vector. Of another one its first two coordinates are factors: its
    /// image vector is the sum of these multiples of the first two points of its carrier.
    std::vector<Vector<Scalar>> points;
    /// Two image points of each line without points; of a line with one point, the second of these
    /// is another point of its image.
    std::vector<std::array<Vector<Scalar>, 2>> lines;
};

template <class Scalar>
using Images = std::vector<ViewImages<Scalar>>;

/// Images on the straight way from one to the other, at this time between 0 and 1.
Images<Moving> on_the_way(const Images<Complex>& from, const Images<Complex>& to, double time);

/// The same as polynomials in time.
Images<Polynomial> straight_way(const Images<Complex>& from, const Images<Complex>& to);

/// The image vectors of all points.
template <class Scalar>
std::vector<Vector<Scalar>> image_vectors(const Problem& problem,
                                          const ViewImages<Scalar>& images) {
    std::vector<Vector<Scalar>> vectors = images.points;
    for (std::size_t p = 0; p < vectors.size(); ++p) {
        const auto carrier = plprove::carrier(problem, static_cast<int>(p));
        if (!carrier) continue;
        const auto& on_it = problem.lines[static_cast<std::size_t>(*carrier)].points;
        const auto& a = vectors[static_cast<std::size_t>(on_it[0])];
        const auto& b = vectors[static_cast<std::size_t>(on_it[1])];
        const Vector<Scalar> factors = vectors[p];
        for (std::size_t i = 0; i < 3; ++i)
            vectors[p][i] = factors[0] * a[i] + factors[1] * b[i];
    }
    return vectors;
}

} // namespace plprove::many_views
