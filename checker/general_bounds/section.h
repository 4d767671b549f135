// A bound on the number of solutions of a problem for projective cameras from above: in a space of
// forms that is the same for all images, those that vanish at the solutions leave few dimensions
// (proofs/fixed_forms.md).
#pragma once

#include "checker/general_bounds/fixed_forms.h"

#include <functional>

namespace checker {
/// Spends so much effort, before it is needed.
using Spend = std::function<void(std::uint64_t effort)>;

/// A bound for a minimal problem, by what its views see and further images do. Throws Refused if
/// these powers do not give one.
std::size_t solutions_at_most(const Problem& problem, const std::vector<Numbers>& views,
                              const Powers& powers, const Spend& spend);
} // namespace checker
