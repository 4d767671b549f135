// Jordan's theorem on primitive groups.
#pragma once

#include <flint/ulong_extras.h>

namespace plprove {

/// Whether every transitive group of this degree that has a permutation with a cycle of this length
/// contains all even permutations: for prime lengths l with d/2 < l < d - 2.
inline bool shows_alternating(int degree, int length) {
    return 2 * length > degree && length + 2 < degree &&
           n_is_prime(static_cast<ulong>(length)) != 0;
}

} // namespace plprove
