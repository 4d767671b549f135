// Vectors of rationals as integers, for certificates of given images.
#pragma once

#include "prover/solver/images.h"
#include "prover/three_views/integer_vectors.h"

#include <optional>

namespace plprove {

/// The proportional integer vector without a common divisor; nothing if a coordinate is larger than
/// `largest`. Assumes that x is not 0.
std::optional<IntegerVector> proportional(const ExactVector& x, std::int64_t largest);

/// The vector of the same direction whose largest coordinate is `largest`, rounded.
IntegerVector nearest(const ExactVector& x, std::int64_t largest);

ExactVector exact(const IntegerVector& x);

mpq_class dot(const ExactVector& a, const ExactVector& b);
ExactVector exact_cross(const ExactVector& a, const ExactVector& b);

/// In radians.
double angle(const ExactVector& a, const ExactVector& b);

} // namespace plprove
