// The degrees of minimal problems in three calibrated views (certs/degrees.csv), embedded in the
// program at build time. Each is certified exactly: plcheck computes it from
// certs/classification.plc.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace plprove {

/// How many solutions for the cameras all minimal problems of a constraint class have: they share
/// their camera equations.
struct ClassDegree {
    std::size_t constraint_class = 0; ///< the number of its first member
    int degree = 0;
};

/// All of them, ascending.
std::span<const ClassDegree> degrees_on_file();

/// The degree of the minimal problems in a constraint class; nothing where they are not minimal.
std::optional<int> degree_on_file(std::size_t constraint_class);

/// The degree of every minimal problem in two views: all reduce to the five-point problem.
inline constexpr int degree_in_two_views = 20;

} // namespace plprove
