// Parts of problems: which classes contain some features, or consist of some of them.
#pragma once

#include "prover/problem/signature.h"

#include <array>
#include <string_view>
#include <vector>

namespace plprove {

/// Features of a problem in three views. A point with a dangling pin, as in P/P/a, stands for
/// either feature of a swap pair: Pa/P/a or P/Pa/a.
struct Part {
    Signature fixed{};                           ///< the features that stand for themselves
    std::array<int, swap_pairs.size()> either{}; ///< how many stand for either of the pair
};

/// Reads a problem (parse_spec) that consists of the 27 features, and of their forms with dangling
/// pins; the result are its images under the six permutations of the views. Throws NotationError.
std::vector<Part> parse_part(std::string_view spec);

/// Whether the problem has the features of the part.
bool contains(const Signature& problem, const Part& part);

/// Whether the part has the features of the problem.
bool is_contained(const Signature& problem, const Part& part);

} // namespace plprove
