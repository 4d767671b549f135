#include "checker/reasons/part.h"

#include "checker/reasons/motions.h"

#include <algorithm>
#include <functional>

namespace checker {
/// Lines that contain two points of the span lie in it, and so do the points on a line of it.
static void close(Span& span, const Problem& problem) {
    for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t n = 0; n < problem.lines.size(); ++n) {
            const Indices& points = problem.lines[n].points;
            const auto inside = std::ranges::count_if(points, std::cref(span));
            if (!span.lines[n] && inside < 2) continue;
            grows = grows || !span.lines[n] || inside < std::ssize(points);
            span.lines[n] = true;
            for (const std::size_t p : points)
                span.points[p] = true;
        }
    }
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
        const bool meets = std::ranges::any_of(problem.lines[n].points, std::cref(span));
        if (!span.lines[n]) span.rank += meets ? 1 : 2;
        span.lines[n] = true;
        close(span, problem);
    }
    return span;
}

bool arises(const Problem& problem, const Selection& part) {
    std::vector<bool> point_out(problem.points.size()), line_out(problem.lines.size());
    // What is not in the part and has at most two neighbours that are still there.
    const auto leave_out = [](auto& out, const Indices& kept, const auto& others_out,
                              const auto& items, auto neighbours) {
        const auto is_there = [&](std::size_t i) { return !others_out[i]; };
        bool changes = false;
        for (std::size_t i = 0; i < out.size(); ++i) {
            if (out[i] || contains(kept, i)) continue;
            if (std::ranges::count_if(items[i].*neighbours, is_there) <= 2) out[i] = changes = true;
        }
        return changes;
    };
    while (leave_out(line_out, part.lines, point_out, problem.lines, &Line::points) ||
           leave_out(point_out, part.points, line_out, problem.points, &Point::lines)) {
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

/// The selection in the numbers of the part.
static Selection selection_in(const Selection& part, Selection selection) {
    if ((selection.views & ~part.views) != 0) throw Refused("a view is not in the part");
    for (std::size_t& p : selection.points)
        p = place_in(part.points, p, "point");
    for (std::size_t& n : selection.lines)
        n = place_in(part.lines, n, "line");
    return selection;
}

static Element element_in(const Selection& part, Element element) {
    using enum Element::Centre;
    element.moved = selection_in(part, element.moved);
    if (element.kind == view) selection_in(part, {.views = Views{1} << element.centre});
    if (element.kind == point) element.centre = place_in(part.points, element.centre, "point");
    if (element.kind == line || element.kind == axis)
        element.centre = place_in(part.lines, element.centre, "line");
    return element;
}

/// The motion in the numbers of the part.
static Motion motion_in(const Selection& part, Motion motion) {
    for (std::size_t& p : motion.joins)
        p = place_in(part.points, p, "point");
    motion.moved = selection_in(part, motion.moved);
    motion.core = selection_in(part, motion.core);
    for (Element& element : motion.elements)
        element = element_in(part, element);
    return motion;
}

Span span_of_generators(const Problem& part, const Selection& moved) {
    const Span span = span_of(part, moved.points, moved.lines);
    if (span.rank > 0 && !part.cameras->all_matrices)
        throw Refused("a motion of ", part.cameras->name, " cameras has no generators");
    if (span.rank > 3) throw Refused("the rank of the generators is ", span.rank, ", more than 3");
    return span;
}

/// κ of a motion `plane`: three parameters of each moving view, less what space contributes, and
/// one for each condition. A line with a point that is not in W rests, so each moving view that
/// sees it makes one.
static int plane_parameters(const Problem& part, const Selection& moved) {
    const Span span = span_of_generators(part, moved);
    for (std::size_t p = 0; p < part.points.size(); ++p)
        if ((part.points[p].seen_by & moved.views) != 0 && !span.points[p])
            throw Refused("the motion does not keep the image of point ", p + 1, " of the part");
    const int resting = std::popcount(part.views & ~moved.views);
    int free = 3 * std::popcount(moved.views) - (resting == 0 ? 4 : resting == 1 ? 1 : 0);
    for (std::size_t n = 0; n < part.lines.size(); ++n) {
        if (span.lines[n]) continue;
        const Line& line = part.lines[n];
        const int changing = std::popcount(line.seen_by & moved.views);
        const bool may_move = std::ranges::all_of(line.points, std::cref(span));
        free -= may_move ? std::min(changing, conditions_in(line.seen_by)) : changing;
    }
    return free;
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

/// κ of a loose line beside that of its loose points. Throws Refused if two of its points rest, or
/// if one of several loose points on it is on another loose line, too.
static int loose_parameters_of(const Problem& part, std::size_t n, const Selection& moved) {
    const Line& line = part.lines[n];
    int loose = 0, seen = 0, joined = 0;
    for (const std::size_t p : line.points) {
        if (!contains(moved.points, p)) continue;
        ++loose;
        seen += std::popcount(line.seen_by & part.points[p].seen_by);
        for (const std::size_t other : part.points[p].lines)
            if (other != n && contains(moved.lines, other)) ++joined;
    }
    if (loose > 1 && joined > 0) throw Refused("a loose point on a loose line is on another one");
    const int resting = static_cast<int>(line.points.size()) - loose;
    if (resting > 1) throw Refused("a loose line contains two points that rest");
    return 4 - 2 * (loose + resting) - (2 - resting) * std::popcount(line.seen_by) + seen;
}

/// κ of points with some lines through them, and of lines with some of their points.
static int loose_parameters(const Problem& part, const Selection& moved) {
    int free = 0;
    for (const std::size_t p : moved.points)
        free += loose_parameters_of(part, p, moved.lines);
    for (const std::size_t n : moved.lines)
        free += loose_parameters_of(part, n, moved);
    return free;
}

/// κ of a camera that moves while all else rests: its unknowns, less the conditions that its images
/// put on them. Three points of a line fix the images of all others.
static int camera_parameters(const Problem& part, Views view) {
    if (part.view_count() < 3) throw Refused("fewer than two cameras of the part rest");
    int free = part.cameras->unknowns - image_dimension(part, view);
    for (const Line& line : part.lines)
        free += std::max(0, count_seen(part, line.points, view) - 3);
    return free;
}

int excess_of(const Problem& problem, const Selection& selection, const Motion& motion) {
    using enum Motion::Kind;
    if (!arises(problem, selection)) throw Refused("the part does not arise by leaving out");
    Problem part = part_of(problem, selection);
    if (motion.projective && part.cameras->all_matrices)
        throw Refused("its cameras are projective");
    if (motion.projective) part.cameras = &projective_cameras;
    const Motion within = motion_in(selection, motion);
    if (motion.kind == directions) return excess_of_directions(part, within);
    if (motion.kind == pencils) return excess_of_pencils(part, within.moved.points[0]);
    const int excess = surplus(part);
    if (motion.kind == loose) return excess + loose_parameters(part, within.moved);
    if (motion.kind == camera) return excess + camera_parameters(part, within.moved.views);
    if (motion.kind == plane) return excess + plane_parameters(part, within.moved);
    if (motion.kind == central) return excess + central_parameters(part, within.elements);
    return excess;
}

void check(const Problem& problem, const PartClaim& claim) {
    const int excess = excess_of(problem, claim.part, claim.motion);
    if (excess != claim.excess) throw Refused("the excess is ", excess);
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
