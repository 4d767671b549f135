// Points, lines through three of them or more, and pins, regardless of views: what is left of a
// problem with complete visibility. One of each isomorphism class.
#pragma once

#include <vector>

namespace plprove {

struct Skeleton {
    std::vector<int> pins;               ///< of each point
    std::vector<std::vector<int>> lines; ///< each of three points or more

    int points() const { return static_cast<int>(pins.size()); }
};

/// The sum of n - 2 over the lines of n points: how many points depend on others.
int dependent_points(const Skeleton& skeleton);

/// The skeletons without pins of 0, 1, ..., `most_points` points, in an order of construction.
std::vector<std::vector<Skeleton>> skeletons(int most_points);

/// The skeleton with its points in an order of construction that is short to write: points on many
/// lines first, points on the same lines together.
Skeleton in_order_of_lines(const Skeleton& skeleton);

/// The ways to give the points of the skeleton `pins` pins in all.
std::vector<Skeleton> with_pins(const Skeleton& skeleton, int pins);

} // namespace plprove
