// The matrix of a quaternion, over any ring.
#pragma once

#include <array>

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

} // namespace plprove
