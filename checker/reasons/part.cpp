#include "checker/reasons/part.h"

#include "checker/reasons/directions.h"

#include <algorithm>

namespace checker {
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

bool arises(Problem problem, const Selection& part) {
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

Problem part_of(const Problem& problem, const Selection& part) {
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
    for (std::size_t& p : result.core.points)
        p = place_in(part.points, p, "point");
    for (std::size_t& n : result.core.lines)
        n = place_in(part.lines, n, "line");
    if ((motion.core.views & ~part.views) != 0)
        throw Refused("a view of the core is not in the part");
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

/// Whether the motion keeps the point, and not only its images: it is O, or lies in W.
static bool keeps(const Motion& motion, const Span& span, std::size_t point) {
    return span.points[point] || (motion.kind == Motion::Kind::star && point == motion.centre);
}

/// What these lines cost: the sum of c times so many conditions. A line with a point that is not
/// kept rests, so each moving view that sees it makes a condition. Any other one may move.
static int cost_of(const Indices& lines, const Problem& part, const Motion& motion,
                   const Span& span) {
    const bool subspace = motion.kind == Motion::Kind::star && part.cameras->all_matrices;
    int cost = 0;
    for (const std::size_t n : lines) {
        const Line& line = part.lines[n];
        const bool two_conditions = subspace && span.rank < 3 && !meets(span, line);
        const bool may_move =
            std::ranges::all_of(line.points, [&](std::size_t p) { return keeps(motion, span, p); });
        const int moving = std::popcount(line.seen_by & motion.moved.views);
        cost += (two_conditions ? 2 : 1) *
                (may_move ? std::min(moving, conditions_in(line.seen_by)) : moving);
    }
    return cost;
}

/// Throws Refused unless each point that a moving view sees is kept.
static void require_kept_points(const Problem& part, const Motion& motion, const Span& span) {
    for (std::size_t p = 0; p < part.points.size(); ++p)
        if ((part.points[p].seen_by & motion.moved.views) != 0 && !keeps(motion, span, p))
            throw Refused("the motion does not keep the image of point ", p + 1, " of the part");
}

/// κ of a loose point: its parameters, less the conditions that its images put on them while all
/// else rests. Throws Refused if it is on two lines that rest.
static int loose_parameters_of(const Problem& part, std::size_t point, const Indices& loose_lines) {
    const auto rests = [&](std::size_t n) { return !contains(loose_lines, n); };
    const Point& moved = part.points[point];
    const auto resting_lines = static_cast<int>(std::ranges::count_if(moved.lines, rests));
    if (resting_lines > 1) throw Refused("a loose point is on two lines that rest");
    return 3 - 2 * resting_lines - (2 - resting_lines) * std::popcount(moved.seen_by);
}

/// κ of a loose line beside that of its loose points, if it contains all of these. Throws Refused
/// if two of its points rest.
static int loose_parameters_of(const Problem& part, const Line& line, const Indices& loose_points) {
    int loose = 0, seen = 0;
    for (const std::size_t p : line.points) {
        if (!contains(loose_points, p)) continue;
        ++loose;
        seen += std::popcount(line.seen_by & part.points[p].seen_by);
    }
    if (loose < std::ssize(loose_points))
        throw Refused("a loose line does not contain a loose point");
    const int resting = static_cast<int>(line.points.size()) - loose;
    if (resting > 1) throw Refused("a loose line contains two points that rest");
    return 4 - 2 * (loose + resting) - (2 - resting) * std::popcount(line.seen_by) + seen;
}

/// κ of a point with some lines through it, or of a line with some of its points.
static int loose_parameters(const Problem& part, const Selection& moved) {
    if (moved.points.size() != 1 && moved.lines.size() != 1)
        throw Refused("what is loose is no point with lines, and no line with points");
    int free = 0;
    for (const std::size_t p : moved.points)
        free += loose_parameters_of(part, p, moved.lines);
    for (const std::size_t n : moved.lines)
        free += loose_parameters_of(part, part.lines[n], moved.points);
    return free;
}

/// κ of a camera that moves while all else rests: its unknowns, less the conditions that its images
/// put on them. Three points of a line fix the images of all others.
static int camera_parameters(const Problem& part, Views view) {
    if (part.view_count() < 3) throw Refused("fewer than two cameras of the part rest");
    int conditions = 0;
    for (const Point& point : part.points)
        if ((point.seen_by & view) != 0) conditions += 2;
    for (const Line& line : part.lines) {
        if ((line.seen_by & view) == 0) continue;
        const auto sees = [&](std::size_t p) { return (part.points[p].seen_by & view) != 0; };
        const auto points = static_cast<int>(std::ranges::count_if(line.points, sees));
        conditions += 2 - points - std::max(0, points - 3);
    }
    return part.cameras->unknowns - conditions;
}

/// Which views see something that moves with these views: what they see, and what is joined to that
/// by incidence.
static Views views_of_moved(const Problem& part, Views moving) {
    Views seeing = moving;
    std::vector<bool> points(part.points.size()), lines(part.lines.size());
    for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t p = 0; p < points.size(); ++p) {
            const auto moves = [&](std::size_t n) { return lines[n]; };
            const Point& point = part.points[p];
            if (points[p] ||
                ((point.seen_by & moving) == 0 && std::ranges::none_of(point.lines, moves)))
                continue;
            points[p] = grows = true;
            seeing |= point.seen_by;
        }
        for (std::size_t n = 0; n < lines.size(); ++n) {
            const auto moves = [&](std::size_t p) { return points[p]; };
            const Line& line = part.lines[n];
            if (lines[n] ||
                ((line.seen_by & moving) == 0 && std::ranges::none_of(line.points, moves)))
                continue;
            lines[n] = grows = true;
            seeing |= line.seen_by;
        }
    }
    return seeing;
}

/// κ of views that move with all that they see, as a motion of space does that keeps the one
/// resting camera that sees some of it.
static int parameters_apart(const Problem& part, Views moving) {
    if (std::popcount(part.views & ~moving) < 2) throw Refused("fewer than two views rest");
    if (std::popcount(views_of_moved(part, moving) & ~moving) > 1)
        throw Refused("two views that rest see what moves");
    return part.cameras->all_matrices ? 4 : 1;
}

/// κ of a motion that is not `none`. Throws Refused if the motion does not keep the images.
static int kernel_dimension(const Problem& part, const Motion& motion) {
    if (motion.kind == Motion::Kind::loose) return loose_parameters(part, motion.moved);
    if (motion.kind == Motion::Kind::camera) return camera_parameters(part, motion.moved.views);
    if (motion.kind == Motion::Kind::apart) return parameters_apart(part, motion.moved.views);
    require_motion(part, motion);
    const Span span = span_of(part, motion.moved.points, motion.moved.lines);
    if (span.rank > 3) throw Refused("the rank of the generators is ", span.rank, ", more than 3");
    const Indices costly = costly_lines(part, motion, span);
    require_kept_points(part, motion, span);
    return freedom(part, motion, span.rank) * std::popcount(motion.moved.views) -
           gain(part, motion, span.rank) - cost_of(costly, part, motion, span);
}

int excess_of(const Problem& problem, const Selection& selection, const Motion& motion) {
    if (!arises(problem, selection)) throw Refused("the part does not arise by leaving out");
    Problem part = part_of(problem, selection);
    if (motion.projective && part.cameras->all_matrices)
        throw Refused("its cameras are projective");
    if (motion.projective) part.cameras = &projective_cameras;
    const Motion within = motion_in(selection, motion);
    if (motion.kind == Motion::Kind::directions) return excess_of_directions(part, within);
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
