// Upper bounds on degrees that points and lines alone imply (proofs/families.md, Theorem 16): for
// projective cameras, two views with unknown focal lengths, and some problems with known verticals.
#pragma once

#include "checker/problem/problem.h"

namespace checker {
/// How many solutions for its cameras, up to motions of space, the problem has at most if it is
/// minimal; none if the theorem does not say.
std::optional<std::size_t> degree_bound(const Problem& problem);
} // namespace checker
