// Images as users have them: in pixels, exact as written, with the calibration of the cameras; and
// the way from there to what the solver wants.
#pragma once

#include "prover/problem/notation.h"
#include "prover/solver/reconstruction.h"

#include <array>
#include <gmpxx.h>
#include <string>

namespace plprove {

using ExactVector = std::array<mpq_class, 3>;

/// An image line: its coefficients, and the two points that it was given by, if it was.
struct GivenLine {
    ExactVector coefficients;
    std::vector<std::array<mpq_class, 2>> points;
};

/// What one view sees of a feature, in pixels, or in normalised coordinates where the view has no
/// calibration.
struct GivenSighting {
    std::optional<ExactVector> point;            ///< the third coordinate is 1
    std::vector<std::optional<GivenLine>> lines; ///< one for each line of the feature
};

/// A problem of which there may be images: its features; and what they do not say where points
/// share lines, there are more than three views, or the cameras are not calibrated.
struct ImagedProblem {
    Features features;
    std::optional<Problem> general{};

    // Either kind is one.
    ImagedProblem(Features local) : features(std::move(local)) {}
    ImagedProblem(const Problem& problem) : features(features_of(problem)), general(problem) {}

    friend bool operator==(const ImagedProblem&, const ImagedProblem&) = default;
};

std::string notation(const ImagedProblem& problem);

/// The images of a problem. What a view is to see by the problem is there, and nothing else; but
/// for lines with two points or more, which these show.
struct GivenImages {
    Features problem;
    std::optional<Problem> general; ///< see ImagedProblem
    std::vector<std::string> names; ///< one for each feature; empty where it has none
    /// One matrix for each view, upper triangular, by rows: from normalised coordinates to pixels.
    std::vector<std::array<ExactVector, 3>> calibration;
    std::vector<std::vector<GivenSighting>> features; ///< [feature][view]
};

/// An exact sighting in normalised coordinates.
struct ExactSighting {
    std::optional<ExactVector> point;
    std::vector<std::optional<ExactVector>> lines;
};

/// Images in normalised coordinates, whose lines pass through the points that they are to pass
/// through.
struct ConsistentImages {
    std::vector<std::vector<ExactSighting>> features; ///< [feature][view]
    double moved =
        0; ///< the largest distance in pixels that a point or line was moved to get there
};

/// Where a line misses its point, both are moved to the nearest ones that meet (consistency.h).
/// Then each point that a line has beside its first two is moved onto the line of these.
ConsistentImages consistent(const GivenImages& images);

/// The same in doubles.
SeenImages rounded(const GivenImages& images, const ConsistentImages& consistent);

/// Throws BadInput where a view sees two points at the same place, or two lines that are equal, or
/// where two views see the same of everything: there are no generic solutions then.
void refuse_degenerate(const GivenImages& images);

/// `feature 2 (Pa/Pa/Pa)`, with its name if it has one.
std::string name_of(const GivenImages& images, std::size_t feature);

} // namespace plprove
