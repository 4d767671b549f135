// Local features: free lines and points with pins, with what each view sees of them. A point-line
// problem with at most one point per line (a PL1P, Definition 4 of the paper) is a sum of local
// features.
//
// A feature is a plain value for any number of views and pins; the 27 features of the reduced
// minimal problems in three views are a list of such values (standard_features). Everything that
// depends on visibility (dimensions, weight, relabeling, which features a view permutation maps to
// which) is derived from the value, not tabulated.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace plprove {

/// What one view sees of a local feature: the point or not, and a set of pins (bit i: pin 'a' + i).
struct Sight {
    bool point = false;
    std::uint32_t pins = 0;
    auto operator<=>(const Sight&) const = default;
};

/// A free line (one line, no point) or a point with `lines` pins, with one Sight per view.
struct Feature {
    bool has_point = true;
    int lines = 0;
    std::vector<Sight> sights;

    int views() const { return static_cast<int>(sights.size()); }
    bool sees_point(int view) const { return sights[static_cast<std::size_t>(view)].point; }
    bool sees_line(int view, int line) const {
        return (sights[static_cast<std::size_t>(view)].pins >> line & 1U) != 0;
    }
    auto operator<=>(const Feature&) const = default;
};

/// The largest number of pins of a point: they are named by the letters a to z.
inline constexpr int max_pins = 26;

/// Degrees of freedom in space: 4 for a free line, 3 + 2k for a point with k pins.
int dimension_in_space(const Feature& feature);

/// Degrees of freedom in view `view`: 2 for a seen point, 1 for a line through a seen point, 2 for
/// a line whose point is not seen.
int dimension_in_view(const Feature& feature, int view);

/// Degrees of freedom in all views less those in space: how many constraints the feature puts on
/// the cameras when it is generic (Table 1 of the paper).
int weight(const Feature& feature);

/// The same feature seen by relabeled views: view v of the result is view from[v] of `feature`.
Feature relabel_views(const Feature& feature, std::span<const int> from);

/// The feature with its pins renamed so that features that differ by the names of their pins become
/// equal.
Feature canonical(const Feature& feature);

/// Whether some view sees the line, or the point.
bool is_seen(const Feature& feature, int line);
bool point_is_seen(const Feature& feature);

/// `Pa/Pa/a`: the views in order, `P` for the point, letters for the pins, `-` for nothing; then,
/// in parentheses, what exists but no view sees.
std::string notation(const Feature& feature);

/// The 27 features of Theorem 3 and Table 1 of the paper, in the authors' order.
const std::vector<Feature>& standard_features();

} // namespace plprove
