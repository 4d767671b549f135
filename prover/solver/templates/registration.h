// Registration problems: what is left of an extension of the five-point problem when the relative
// pose of two views with five points in common is known (proofs/registrations.md, section 1).
#pragma once

#include "prover/problem/signature.h"

#include <compare>
#include <map>
#include <vector>

namespace plprove::templates {

/// The conditions that registration puts on the third camera, six in all.
struct Registration {
    /// For each known point that it sees: how many known lines through the point it sees as well.
    /// Ascending.
    std::vector<int> stars;
    /// Known lines that it sees.
    int lines = 0;
    /// Known points that it does not see, though it sees a line through each.
    int incidences = 0;
    /// Known lines that meet the rays of points that it sees (transversals), by how many of them
    /// have a point in common: rays of one of the two cameras. Ascending.
    std::vector<int> groups;

    auto operator<=>(const Registration&) const = default;
};

/// The relative pose of two views that share five points is of this kind as well: the rays of one
/// camera are the known lines, which have its centre in common.
Registration relative_pose();

/// What is left of `signature` for the camera of view `third` (0, 1, 2), the relative pose of the
/// other two views being known.
Registration registration(const Signature& signature, int third);

/// In how many label classes, of minimal problems, a type occurs; all types that occur.
std::map<Registration, int> registration_types(const std::vector<Signature>& classes);

/// A type in words: "stars 1 0, lines 1, incidences 0, transversals none".
std::string describe(const Registration& type);

} // namespace plprove::templates
