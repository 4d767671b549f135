// What `plprove degree` does with problems in general: many views, shared lines, other cameras.
#pragma once

#include "prover/cli/command.h"
#include "prover/many_views/upper_bound.h"
#include "prover/problem/problem.h"

#include <cstdint>
#include <string>

namespace plprove {

struct ManyViewsDegreeRequest {
    std::uint64_t seed = 0;
    int target = 0;   ///< stop at this number of solutions; 0: find all
    int at_least = 0; ///< only write a certificate of this number; 0: of all that are found
    std::string path; ///< of the certificate; empty: none is written
    bool json = false;
};

/// Writes a certificate of an upper bound, for projective cameras that all see everything. Throws
/// BadInput for other problems. Returns the exit status.
int propose_upper_bound(const Problem& problem, const many_views::Powers& powers,
                        std::uint64_t seed, const std::string& path, const Deliver& deliver);

/// Computes the degree, writes the certificate, and prints both. Throws BadInput if the problem is
/// not minimal, or if a certificate is asked for and a view misses something. Returns the exit
/// status.
int find_many_views_degree(const Problem& problem, const ManyViewsDegreeRequest& request,
                           const Deliver& deliver);

} // namespace plprove
