// Why a problem is not minimal: the images of a part of it satisfy a condition (FORMAT.md, section
// 13). Each claim is checked by counting on the incidences; there are no coordinates. If views 1
// and 2 of projective cameras share eight points, say, then the images of these have 32 dimensions,
// the points 24, the two cameras 7: the images satisfy one condition, and no motion is needed.
#pragma once

#include "checker/file/reader.h"
#include "checker/problem/problem.h"

namespace checker {
/// Views, points and lines of a problem.
struct Selection {
    Views views = 0;
    Indices points{};
    Indices lines{};
};

/// Cameras that move as by a central collineation, one that keeps the lines through a centre, and
/// the generators; or that turn about an axis.
struct Element {
    enum class Centre { point, line, view, axis };
    Centre kind = Centre::point;
    std::size_t centre = 0; // a point; a line, on it a generic point; a view's camera; an axis
    Selection moved{};      // its views; the generators, of the motion and its own
};

/// A motion of cameras, or of what is loose, that keeps the images of a part; or none, but a reason
/// to count anew, perhaps with a core, which is a part of the part.
struct Motion {
    enum class Kind { none, loose, camera, plane, central, directions, pencils };
    Kind kind = Kind::none;
    bool projective = false; // the cameras are taken as projective ones
    Indices joins{};         // pairs of points, one after the other: of directions
    Selection moved{};       // moving views and generators; what is loose; the point O of pencils
    std::vector<Element> elements{}; // of a central motion
    Selection core{};                // of directions; without views: none
};

/// Not minimal: two views see four points of a line.
struct CollinearClaim {
    Indices points{};
    Views views = 0;
};

/// Not minimal: the images of this part satisfy `excess` conditions.
struct PartClaim {
    int excess = 0;
    Selection part{};
    Motion motion{};
};

/// The subspace that some points and lines of a problem span: what is known to lie in it.
struct Span {
    int rank = 0;
    std::vector<bool> points{};
    std::vector<bool> lines{};
    bool operator()(std::size_t point) const { return points[point]; } // whether it contains it
    bool operator==(const Span&) const = default;
};

Span span_of(const Problem& problem, const Indices& points, const Indices& lines);

inline bool contains(const Indices& list, std::size_t index) {
    return std::ranges::find(list, index) != list.end();
}

/// How many of the points a view sees.
inline int count_seen(const Problem& part, const Indices& points, Views view) {
    const auto sees = [&](std::size_t p) { return (part.points[p].seen_by & view) != 0; };
    return static_cast<int>(std::ranges::count_if(points, sees));
}

/// Whether one can get from the problem to the part: leaves out what may be left out, a line with
/// at most two points, a point on at most two lines, as long as anything may.
bool arises(const Problem& problem, const Selection& part);

/// The part as a problem. Its points and lines have new numbers.
Problem part_of(const Problem& problem, const Selection& part);

/// What so many views say of a line in a known direction, beyond the two numbers of the direction.
inline int conditions_in(Views views) {
    return std::max(0, std::popcount(views) - 2);
}

/// How many conditions the images satisfy by such a part and motion, whatever is claimed; perhaps
/// none. Throws Refused if it is no part, or if the motion does not keep the images.
int excess_of(const Problem& problem, const Selection& part, const Motion& motion);

// Throw Refused unless the claim holds.
void check(const Problem& problem, const PartClaim& claim);
void check(const Problem& problem, const CollinearClaim& claim);
} // namespace checker
