// Minimal problems one feature away from one that is not: what a user might add, drop or exchange.
#pragma once

#include "prover/minimal/change.h"
#include "prover/minimal/decision.h"

#include <vector>

namespace plprove {

/// A change by one feature, and what it makes of the problem.
struct Hint : Change {
    Decision decision; ///< minimal, or camera-minimal if reducing the rest leaves the scene open
};

/// Larger problems get no hints.
inline constexpr std::size_t most_features_with_hints = 40;

/// All changes by one feature that make the decided problem minimal: of a camera-minimal one, what
/// to drop, or which dangling pin to fix; of an under-constrained one, which of the features of
/// Theorem 3 to add (in two views: a point); of an over-constrained one, what to drop; of an
/// obstructed one, what to exchange. One hint for each label class, the first. Nothing for a
/// minimal problem.
std::vector<Hint> hints(const Decision& decision);

} // namespace plprove
