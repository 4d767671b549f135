// Three views with a known vertical (proofs/upright_views.md, Theorem D).
#pragma once

#include "checker/problem/problem.h"

namespace checker {
/// The degree of a minimal problem. None if the theorem does not say it: that is for other cameras
/// or numbers of views, if a line joins points, or if the search does not end well. Time: seconds.
std::optional<std::size_t> degree_in_upright_views(const Problem& problem);
} // namespace checker
