// Larger problems that fix the cameras in the same way: what a user may add to a minimal problem so
// that it stays minimal.
#pragma once

#include "prover/problem/notation.h"

#include <optional>
#include <vector>

namespace plprove {

/// A feature to add, or to put for one that the problem has.
struct Extension {
    std::optional<Feature> replaced;
    Feature added;

    auto operator<=>(const Extension&) const = default;
};

/// `add a/a/-`, `put Pa/a/a for a/a/a`.
std::string in_words(const Extension& extension);

/// The problem with that change.
Features extended(const Features& problem, const Extension& extension);

/// What may be added to a minimal problem in two or three views: a free line, a point, a point with
/// a pin; to one of its points a pin, to one of its free lines a point. All ways to see them that
/// one step of the reduction takes back, and that leave the problem balanced. By Theorem 4 of the
/// paper the larger problem is minimal, with the same degree.
std::vector<Extension> extensions(const Features& problem);

} // namespace plprove
