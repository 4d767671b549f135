// A trace test for six views of a point on a line and two free lines, 1021_1: evidence that no
// solution is missing.
//
// In the last view the line a moves in a pencil, l(t) = l0 + t l1, and its point x with it, along
// the line k through x that meets the images m, n of the free lines in one point. Everything else
// stays. Let the point be the origin of space. Then the view says of its rotation R and of the
// depth s of its point: l is orthogonal to R d, where d is the direction of a; and the planes with
// normals R^T m, R^T n and heights s m·x, s n·x contain the free lines. All points of k have the
// same ratio m·x : n·x. So the view depends on l alone, by one linear equation for z = R d.
//
// The other equations define a curve, and z takes it to a plane curve. The solutions at time t are
// the points of the curve on the line l(t). These lines meet in one point, which is random. So the
// sum of w·z / l1·z over all solutions, where w is any vector, is a polynomial of degree one in t.
// A sum over some of them is not, unless they fill components of the curve.
#pragma once

#include "prover/many_views/system.h"

#include <vector>

namespace plprove::many_views {

/// The images of the pencil.
class ImagesInPencil {
public:
    /// Assumes that the system is of 1021_1. The images are those at time 0.
    ImagesInPencil(const System& system, const Images<Complex>& images, Random& random);

    Images<Complex> at(const Complex& time) const;

    /// The last view's image of line a at that time.
    Eigen::Vector3cd line_at(const Complex& time) const { return l0_ + time * l1_; }
    /// z of a solution at any time.
    Eigen::Vector3cd direction(const Point& solution) const;
    /// w·z / l1·z of a solution at any time.
    Complex coordinate(const Point& solution) const;

private:
    const System& system_;
    Images<Complex> images_;
    std::size_t line_ = 0; ///< the index of a
    Eigen::Index depth_;   ///< of the point of a that is not the point, among the unknowns
    Eigen::Vector3cd l0_, l1_, k_, other_, w_;
};

struct PencilTrace {
    int solutions = 0;         ///< that have been followed to each of two other times
    int lost = 0;              ///< where this failed: if any, the test says nothing
    Complex slope;             ///< of the sum, from time 0 to the first
    double difference = 0;     ///< of this slope and that to the second time: 0 if none is missing
    double if_one_missing = 0; ///< the difference that a missing solution makes: the median
};

/// Follows solutions of these images.
PencilTrace trace_in_pencil(const System& system, const Images<Complex>& images,
                            const std::vector<Point>& solutions, std::uint64_t seed, int threads);

} // namespace plprove::many_views
