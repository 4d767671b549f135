// Point-line problems: calibrated or projective cameras, any number of views, lines with any number
// of points, and what each view sees. docs/notation.md says how they are written.
//
// A problem is a plain value. Its points are in an order of construction: a point is free (3
// parameters), or it lies on one line through two earlier points (1 parameter). All dimensions
// follow from this order (certs/FORMAT.md, section 13).
#pragma once

#include "prover/cameras/camera_model.h"
#include "prover/problem/feature.h"

#include <optional>
#include <stdexcept>
#include <vector>

namespace plprove {

inline constexpr int most_views = 12;
inline constexpr int most_points = 100;
inline constexpr int most_lines = 100;

/// A line: the points on it, ascending, and the views that see it.
struct Line {
    std::vector<int> points;
    ViewSet seen = 0;
    auto operator<=>(const Line&) const = default;
};

/// Points and lines in space, and the views that see them. Two lines share at most one point. A
/// view that sees two points of a line sees the line; a view that sees two lines of a point sees
/// the point.
struct Problem {
    const CameraModel* cameras = &calibrated_cameras;
    int views = 0;
    std::vector<ViewSet> points; ///< of each point, the views that see it
    std::vector<Line> lines;
    auto operator<=>(const Problem&) const = default;
};

/// A text that is not a problem: what was found, at which column (from 1), and what was expected;
/// or points and lines that cannot be, and what to write instead.
class NotationError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The sum of these features, in this order. Throws NotationError if there are too many points or
/// lines; whether they can be, see refuse_invalid().
Problem problem_of(const Features& features, const CameraModel& cameras = calibrated_cameras);

/// The features of the problem: first the points in their order, each with its pins, then the free
/// lines. Throws NotationError if there are too many lines to name them by letters.
Features features_of(const Problem& problem);

/// The features of the problem without its implied lines. Such a line has two points, and each view
/// that sees it sees both: it has no parameters in space and in images. Nothing if points share
/// other lines.
std::optional<Features> features_without_implied_lines(const Problem& problem);

/// The same, as the classification has them: nothing if cameras are not calibrated, or there are
/// more than three views.
std::optional<Features> local_features(const Problem& problem);

/// Throws NotationError if there are too many points or lines, two lines share two points, a view
/// sees two points of a line that it does not see, or two lines of a point that it does not see, or
/// the points have no order of construction.
void refuse_invalid(const Problem& problem);

/// Whether the line contains the point.
bool contains(const Line& line, int point);

/// The numbers of the lines through the point.
std::vector<int> lines_through(const Problem& problem, int point);

/// Of the line's points, those that view `view` sees.
std::vector<int> seen_points(const Problem& problem, const Line& line, int view);

/// The line through `point` on which two earlier points lie; nothing for a free point. Assumes the
/// order of construction.
std::optional<int> carrier(const Problem& problem, int point);

/// How many more points fix the line, beside the points on it: two, one or none.
int own_points(const Line& line);

/// The same problem with its points in an order of construction; the given order, if it is one.
/// Nothing if there is none.
std::optional<Problem> in_order_of_construction(const Problem& problem);

/// Parameters of the points and lines in space.
int dimension_in_space(const Problem& problem);

/// Parameters of what view `view` sees.
int dimension_in_view(const Problem& problem, int view);

/// The sum of dimension_in_view over all views.
int dimension_in_views(const Problem& problem);

/// Whether the images put one constraint for each parameter of cameras and scene.
bool is_balanced(const Problem& problem);

} // namespace plprove
