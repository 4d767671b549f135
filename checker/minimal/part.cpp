#include "checker/minimal/part.h"

#include <algorithm>
#include <numeric>

namespace checker {
static bool contains(const Indices& list, std::size_t index) {
    return std::ranges::find(list, index) != list.end();
}

/// Lines that contain two points of the span lie in it, and so do the points on a line of it.
static void close(Span& span, const Problem& problem) {
    for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t n = 0; n < problem.lines.size(); ++n) {
            const Indices& points = problem.lines[n].points;
            const auto lies_in = [&](std::size_t p) { return span.points[p]; };
            const auto inside = std::ranges::count_if(points, lies_in);
            if (!span.lines[n] && inside < 2) continue;
            grows = grows || !span.lines[n] || inside < std::ssize(points);
            span.lines[n] = true;
            for (const std::size_t p : points)
                span.points[p] = true;
        }
    }
}

/// Whether the line contains a point of the span.
static bool meets(const Span& span, const Line& line) {
    return std::ranges::any_of(line.points, [&](std::size_t p) { return span.points[p]; });
}

Span span_of(const Problem& problem, const Indices& points, const Indices& lines) {
    Span span;
    span.points.resize(problem.points.size());
    span.lines.resize(problem.lines.size());
    for (const std::size_t p : points) {
        if (!span.points[p]) span.rank += 1;
        span.points[p] = true;
        close(span, problem);
    }
    for (const std::size_t n : lines) {
        if (!span.lines[n]) span.rank += meets(span, problem.lines[n]) ? 1 : 2;
        span.lines[n] = true;
        close(span, problem);
    }
    return span;
}

/// Whether one can get from the problem to the part: leaves out what may be left out, a line with
/// at most two points, a point on at most two lines, as long as anything may.
static bool arises(Problem problem, const Selection& part) {
    std::vector<bool> point_out(problem.points.size()), line_out(problem.lines.size());
    const auto points_on = [&](std::size_t line) {
        return std::ranges::count_if(problem.lines[line].points,
                                     [&](std::size_t p) { return !point_out[p]; });
    };
    const auto lines_through = [&](std::size_t point) {
        return std::ranges::count_if(problem.points[point].lines,
                                     [&](std::size_t n) { return !line_out[n]; });
    };
    for (bool changes = true; changes;) {
        changes = false;
        for (std::size_t n = 0; n < line_out.size(); ++n) {
            if (line_out[n] || contains(part.lines, n) || points_on(n) > 2) continue;
            line_out[n] = changes = true;
        }
        for (std::size_t p = 0; p < point_out.size(); ++p) {
            if (point_out[p] || contains(part.points, p) || lines_through(p) > 2) continue;
            point_out[p] = changes = true;
        }
    }
    const auto left_out = std::ranges::count(point_out, true) + std::ranges::count(line_out, true);
    return left_out + std::ssize(part.points) + std::ssize(part.lines) ==
           std::ssize(point_out) + std::ssize(line_out);
}

/// The place of each index in the list.
static std::size_t place_in(const Indices& list, std::size_t index, const char* what) {
    const auto place = std::ranges::find(list, index);
    if (place == list.end()) throw Refused(what, ' ', index + 1, " is not in the part");
    return static_cast<std::size_t>(place - list.begin());
}

/// The part as a problem. Its points and lines have new numbers.
static Problem part_of(const Problem& problem, const Selection& part) {
    Problem result{.cameras = problem.cameras, .views = part.views};
    for (const std::size_t p : part.points)
        result.points.push_back({.seen_by = problem.points[p].seen_by & part.views});
    for (const std::size_t n : part.lines) {
        const std::size_t line = result.lines.size();
        result.lines.push_back({.seen_by = problem.lines[n].seen_by & part.views});
        for (const std::size_t p : problem.lines[n].points) {
            if (!contains(part.points, p)) continue;
            const std::size_t point = place_in(part.points, p, "point");
            result.lines[line].points.push_back(point);
            result.points[point].lines.push_back(line);
        }
    }
    return result;
}

/// The motion in the numbers of the part.
static Motion motion_in(const Selection& part, const Motion& motion) {
    Motion result = motion;
    if (motion.kind == Motion::Kind::star || motion.kind == Motion::Kind::pencils)
        result.centre = place_in(part.points, motion.centre, "point");
    for (std::size_t& p : result.joins)
        p = place_in(part.points, p, "point");
    for (std::size_t& p : result.moved.points)
        p = place_in(part.points, p, "point");
    for (std::size_t& n : result.moved.lines)
        n = place_in(part.lines, n, "line");
    if ((motion.moved.views & ~part.views) != 0) throw Refused("a moving view is not in the part");
    return result;
}

/// How many parameters each moving view has.
static int freedom(const Problem& part, const Motion& motion, int rank) {
    if (motion.kind == Motion::Kind::plane) return 3;
    return part.cameras->all_matrices ? 4 - rank : 1;
}

/// What space contributes: g.
static int gain(const Problem& part, const Motion& motion, int rank) {
    const bool plane = motion.kind == Motion::Kind::plane;
    const int resting = std::popcount(part.views & ~motion.moved.views);
    if (resting == 0) return plane ? 4 : freedom(part, motion, rank);
    return plane && resting == 1 ? 1 : 0;
}

/// Throws Refused if such cameras have no such motion.
static void require_motion(const Problem& part, const Motion& motion) {
    const CameraModel& cameras = *part.cameras;
    const bool generated = !motion.moved.points.empty() || !motion.moved.lines.empty();
    if (generated && !cameras.all_matrices)
        throw Refused("a motion of ", cameras.name, " cameras has no generators");
}

/// What so many views say of a line in a known direction, beyond the two numbers of the direction.
static int conditions_in(Views views) {
    return std::max(0, std::popcount(views) - 2);
}

/// The lines that cost: a moving view sees them, and they neither lie in W nor contain O.
static Indices costly_lines(const Problem& part, const Motion& motion, const Span& span) {
    const bool star = motion.kind == Motion::Kind::star;
    Indices costly;
    for (std::size_t n = 0; n < part.lines.size(); ++n) {
        const Line& line = part.lines[n];
        const bool moves = (line.seen_by & motion.moved.views) != 0;
        const bool through_centre = star && contains(line.points, motion.centre);
        if (moves && !span.lines[n] && !through_centre) costly.push_back(n);
    }
    return costly;
}

/// What these lines cost: the sum of c min(n - 2, moving views), or of 0.
static int cost_of(const Indices& lines, const Problem& part, const Motion& motion,
                   const Span& span) {
    const bool subspace = motion.kind == Motion::Kind::star && part.cameras->all_matrices;
    int cost = 0;
    for (const std::size_t n : lines) {
        const Line& line = part.lines[n];
        const bool two_conditions = subspace && span.rank < 3 && !meets(span, line);
        const int moving = std::popcount(line.seen_by & motion.moved.views);
        cost += (two_conditions ? 2 : 1) * std::min(moving, conditions_in(line.seen_by));
    }
    return cost;
}

/// Throws Refused unless each point that counts is O or lies in W. Those count that a moving view
/// sees, or that lie on a line that costs.
static void require_kept_points(const Problem& part, const Motion& motion, const Span& span,
                                const Indices& costly) {
    const auto costs = [&](std::size_t line) { return contains(costly, line); };
    for (std::size_t p = 0; p < part.points.size(); ++p) {
        const Point& point = part.points[p];
        const bool is_centre = motion.kind == Motion::Kind::star && p == motion.centre;
        if (is_centre || span.points[p]) continue;
        if ((point.seen_by & motion.moved.views) != 0 || std::ranges::any_of(point.lines, costs))
            throw Refused("the motion does not keep the image of point ", p + 1, " of the part");
    }
}

/// κ of a motion that is not `none`. Throws Refused if the motion does not keep the images.
static int kernel_dimension(const Problem& part, const Motion& motion) {
    require_motion(part, motion);
    const Span span = span_of(part, motion.moved.points, motion.moved.lines);
    if (span.rank > 3) throw Refused("the rank of the generators is ", span.rank, ", more than 3");
    const Indices costly = costly_lines(part, motion, span);
    require_kept_points(part, motion, span, costly);
    return freedom(part, motion, span.rank) * std::popcount(motion.moved.views) -
           gain(part, motion, span.rank) - cost_of(costly, part, motion, span);
}

/// Throws Refused unless the joins, pairs of points, form a forest.
static void require_forest(const Indices& joins, std::size_t points) {
    Indices tree(points);
    std::iota(tree.begin(), tree.end(), std::size_t{0});
    for (std::size_t i = 0; i < joins.size(); i += 2) {
        const std::size_t a = tree[joins[i]], b = tree[joins[i + 1]];
        if (a == b) throw Refused("the joins close a circle");
        std::ranges::replace(tree, a, b);
    }
}

/// What is left over when the directions of lines and joins are counted, and the cameras without
/// their translations.
static int excess_of_directions(const Problem& part, const Indices& joins) {
    if (part.cameras->all_matrices) throw Refused("projective cameras have no `directions`");
    int excess = 3 * part.view_count() - 4 - camera_columns(part);
    for (const Line& line : part.lines) {
        if (line.points.size() > 1) throw Refused("a line of the part has two points");
        excess += conditions_in(line.seen_by);
    }
    require_forest(joins, part.points.size());
    for (std::size_t i = 0; i < joins.size(); i += 2)
        excess += conditions_in(part.points[joins[i]].seen_by & part.points[joins[i + 1]].seen_by);
    return excess;
}

/// What is left over when the lines from a point are counted, and what each view makes of them: a
/// pencil of image lines, by a map that has five numbers.
static int excess_of_pencils(const Problem& part, std::size_t centre) {
    if (!part.cameras->all_matrices)
        throw Refused(part.cameras->name, " cameras have no `pencils`");
    if (part.points[centre].seen_by != part.views)
        throw Refused("a view of the part does not see the point of the pencils");
    int excess = 8 - 5 * part.view_count();
    for (const Line& line : part.lines) {
        if (line.points != Indices{centre}) throw Refused("a line of the part is in no pencil");
        excess += conditions_in(line.seen_by);
    }
    for (std::size_t p = 0; p < part.points.size(); ++p)
        if (p != centre) excess += conditions_in(part.points[p].seen_by);
    return excess;
}

int excess_of(const Problem& problem, const Selection& selection, const Motion& motion) {
    if (!arises(problem, selection)) throw Refused("the part does not arise by leaving out");
    Problem part = part_of(problem, selection);
    if (motion.projective && part.cameras->all_matrices)
        throw Refused("its cameras are projective");
    if (motion.projective) part.cameras = &projective_cameras;
    const Motion within = motion_in(selection, motion);
    if (motion.kind == Motion::Kind::directions) return excess_of_directions(part, within.joins);
    if (motion.kind == Motion::Kind::pencils) return excess_of_pencils(part, within.centre);
    if (motion.kind == Motion::Kind::none) return surplus(part);
    return surplus(part) + kernel_dimension(part, within);
}

void check(const Problem& problem, const PartClaim& claim) {
    const int excess = excess_of(problem, claim.part, claim.motion);
    if (excess != claim.excess) throw Refused("the excess is ", excess);
    if (excess < 1) throw Refused("an excess of ", excess, " proves nothing");
}

void check(const Problem& problem, const CollinearClaim& claim) {
    const auto holds_all = [&](const Line& line) {
        const auto is_on_line = [&](std::size_t p) { return contains(line.points, p); };
        return std::ranges::all_of(claim.points, is_on_line);
    };
    if (std::ranges::none_of(problem.lines, holds_all))
        throw Refused("the four points are not on one line");
    for (const std::size_t p : claim.points)
        if ((claim.views & ~problem.points[p].seen_by) != 0)
            throw Refused("one of the views does not see point ", p + 1);
}
} // namespace checker
