// When to believe that no solution is missing: solutions are followed along more and more edges
// until they permute them, and the trace test finds nothing missing. This is evidence, no proof.
#pragma once

#include "prover/degree/degree.h"
#include "prover/degree/monodromy.h"

namespace plprove {

/// With how many edges a search begins, and with how many it ends in vain.
inline constexpr int first_edges = 3;
inline constexpr int most_edges = 12;
/// Beside the trace test, so many edges are to match all solutions: what two permute, loops
/// permute.
inline constexpr int agreeing_edges = 2;

/// Follows solutions along more and more edges, at least `edges`, until nothing speaks against
/// their being all, or there are `target` of them (0: any number). Returns nothing, and adds a note
/// that says why, if something speaks against it, or if some are spurious zeros; nothing without a
/// note if the target was reached.
std::optional<CompletenessEvidence> complete(const CameraSystem& system, Monodromy& monodromy,
                                             int edges, int target, Random& random,
                                             std::vector<std::string>& notes);

} // namespace plprove
