// What is known of a problem of points and lines.
#pragma once

#include <pointline/result.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pointline {

struct Problem {
    std::string notation; ///< such as 2*Pa/Pa/Pa + P/P/P
    int views = 0;
    bool calibrated = true; ///< whether the cameras are
    /// `minimal`, `camera-minimal`, or why it is neither: `obstructed`, `under-constrained`,
    /// `over-constrained`. With lines through several points, more than three views or uncalibrated
    /// cameras `minimal`, `not minimal`, `unbalanced`, or `open` where that is not known.
    std::string verdict;
    std::vector<std::string> reasons; ///< sentences
    /// The degree on file, or 20 for five points in two views; nothing where none is known.
    std::optional<int> degree;
    std::string picture; ///< SVG: what each view sees
    /// For each feature whether it has a point, and its lines by their letters, without those
    /// through several points.
    std::vector<bool> points;
    std::vector<std::string> lines;
};

/// Reads and decides a problem: notation, a name, or the authors' number. Fails where it is none.
Result<Problem> problem(std::string_view text) noexcept;

} // namespace pointline
