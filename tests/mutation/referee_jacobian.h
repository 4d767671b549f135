// What the referee computes of a certificate: Jacobians built column by column from the motion of
// each unknown, their minors and ranks from whole matrices.
#pragma once

#include "prover/problem/signature.h"
#include "tests/mutation/referee.h"

#include <gmpxx.h>

#include <array>
#include <stdexcept>
#include <vector>

namespace referee {
using Words = std::vector<std::string>;
using Vector = std::array<mpz_class, 3>;

/// What is wrong with a file.
struct Objection : std::runtime_error {
    using std::runtime_error::runtime_error;
};

inline void demand(bool holds, const char* otherwise) {
    if (!holds) throw Objection(otherwise);
}

/// The number that a word is. Objects if it is none, or `index` if it is not one below a million.
mpz_class integer(const std::string& word);
std::size_t index(const std::string& word);

struct Camera {
    std::array<mpz_class, 4> quaternion{1, 0, 0, 0};
    Vector translation{0, 0, 0};

    /// The rotation of a vector v as q v q*, for the quaternion q: no matrix is involved.
    Vector turn(const Vector& v) const;
};

struct Placed {
    plprove::Feature feature;
    Vector point;
    std::vector<Vector> directions;
};

struct Pool {
    std::vector<Camera> cameras{Camera{}}; // camera 1 first
    std::vector<Placed> features;
};

/// The pool that begins on line `at`, which is left behind it.
Pool read_pool(const Text& file, std::size_t& at, int views);

struct Jacobian {
    std::vector<std::vector<mpz_class>> rows;
    std::size_t own = 0;     ///< columns of the features
    std::size_t cameras = 0; ///< columns of the cameras
};

/// Objects to points that section 2 excludes.
Jacobian jacobian(const std::vector<Placed>& features, const std::vector<Camera>& cameras);

/// The determinant modulo q without these rows and columns, counted from 0.
std::uint64_t minor_without(const Jacobian& j, const std::vector<std::size_t>& rows,
                            const std::vector<std::size_t>& columns);

/// The rank over the rationals of the own columns, with one more column beside them if given.
long own_rank(const Jacobian& j, const std::vector<mpz_class>* beside);
} // namespace referee
