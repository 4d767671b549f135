// The matrix of a quaternion, over any ring.
#pragma once

#include <array>
#include <complex>
#include <span>

namespace plprove {

/// The matrix of (a, b, c, d), row by row: a^2 + b^2 + c^2 + d^2 times a rotation (certs/FORMAT.md,
/// section 2).
template <class T>
std::array<std::array<T, 3>, 3> quaternion_matrix(const std::array<T, 4>& quaternion) {
    const auto& [a, b, c, d] = quaternion;
    const auto twice = [](const T& x) { return x + x; };
    return {{{a * a + b * b - c * c - d * d, twice(b * c - a * d), twice(b * d + a * c)},
             {twice(b * c + a * d), a * a - b * b + c * c - d * d, twice(c * d - a * b)},
             {twice(b * d - a * c), twice(c * d + a * b), a * a - b * b - c * c + d * d}}};
}

/// Whether the sum of the squares of complex numbers is zero, nearly: the matrix of such a
/// quaternion has rank 1.
inline bool is_nearly_null(std::span<const std::complex<double>> quaternion) {
    constexpr double small = 1e-8; // of all squares
    std::complex<double> norm = 0;
    double size = 0;
    for (const std::complex<double>& x : quaternion) {
        norm += x * x;
        size += std::norm(x);
    }
    return std::abs(norm) < small * size;
}

} // namespace plprove
