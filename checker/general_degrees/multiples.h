// Theorem G of proofs/multiples.md: degrees of m calibrated cameras are multiples of 2^m.
#pragma once

#include "checker/problem/problem.h"

#include <cstddef>

namespace checker {
/// The least number of solutions that a minimal problem can have if so many are counted.
std::size_t at_least(const Problem& problem, std::size_t counted);
} // namespace checker
