#include "checker/reasons/motions.h"

#include <algorithm>
#include <map>

namespace checker {
/// What moves with an element.
struct Moved {
    std::vector<bool> points{};
    std::vector<bool> lines{};
};

/// The views in which the image of what moves with the element stays.
static Views views_that_keep(const Element& element) {
    if (element.kind != Element::Centre::view) return element.views;
    const Views centre = Views{1} << element.centre;
    if ((element.views & centre) != 0) throw Refused("a view moves about its own centre");
    return element.views | centre;
}

/// Whether the element moves the line in itself: one through its centre, or the axis.
static bool is_through_centre(const Problem& part, std::size_t line, const Element& element) {
    if (element.kind == Element::Centre::point)
        return contains(part.lines[line].points, element.centre);
    return element.kind != Element::Centre::view && element.centre == line;
}

/// What moves: points that moving views see, but those in W, the centre and those on the axis;
/// lines with such a point, and lines that only these views see, with all such points on them.
/// Throws Refused if another view sees such a point.
static Moved moved_with(const Problem& part, const Element& element, const Span& span) {
    const Views keeping = views_that_keep(element);
    const auto is_fixed = [&](std::size_t p) {
        using enum Element::Centre;
        if (element.kind == axis) return contains(part.lines[element.centre].points, p);
        return span.points[p] || (element.kind == point && element.centre == p);
    };
    Moved moved{std::vector<bool>(part.points.size()), std::vector<bool>(part.lines.size())};
    for (std::size_t p = 0; p < part.points.size(); ++p)
        moved.points[p] = count_seen(part, {p}, element.views) > 0 && !is_fixed(p);
    const auto moves = [&](std::size_t p) { return moved.points[p]; };
    const auto may_move = [&](std::size_t p) {
        return is_fixed(p) || (part.points[p].seen_by & ~keeping) == 0;
    };
    for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t n = 0; n < part.lines.size(); ++n) {
            const Line& line = part.lines[n];
            if (moved.lines[n] || span.lines[n] || is_through_centre(part, n, element)) continue;
            const bool alone =
                (line.seen_by & ~keeping) == 0 && std::ranges::all_of(line.points, may_move);
            if (!alone && std::ranges::none_of(line.points, moves)) continue;
            moved.lines[n] = grows = true;
            for (const std::size_t p : line.points)
                moved.points[p] = !is_fixed(p);
        }
    }
    for (std::size_t p = 0; p < part.points.size(); ++p)
        if (moves(p) && !may_move(p))
            throw Refused("the motion does not keep the image of point ", p + 1, " of the part");
    return moved;
}

/// Throws Refused unless different parameters are different motions of cameras: a view belongs to
/// one element about a point and one other at most; and two views rest, or move about the same
/// point alone. An element with an axis is alone, and a view rests.
static void require_independent(const Problem& part, const std::vector<Element>& elements) {
    using enum Element::Centre;
    std::map<std::size_t, Views> about; // a point
    Views about_points = 0, others = 0;
    for (const Element& element : elements) {
        if (element.kind == axis) {
            if (!part.cameras->may_turn) throw Refused(part.cameras->name, " cameras do not turn");
            if (elements.size() > 1) throw Refused("an element with an axis is not the only one");
            if (element.views == part.views) throw Refused("no view rests");
            return;
        }
        Views& such = element.kind == point ? about_points : others;
        if (const Views twice = such & element.views; twice != 0)
            throw Refused("view ", std::countr_zero(twice) + 1,
                          " belongs to two elements of a kind");
        such |= element.views;
        if (element.kind == point) about[element.centre] |= element.views;
    }
    int together = 0; // plain views that move about the same point
    for (const auto& [centre, views] : about)
        together = std::max(together, std::popcount(views & ~others));
    if (std::popcount(part.views & ~others & ~about_points) + together < 2)
        throw Refused("no two views rest, or move about the same point alone");
}

/// The conditions on the parameters so that the images of a line stay: in each view in which an
/// element would change the image, one or two. A line that may move alone takes all but those
/// beyond its own parameters.
static int conditions_of(const Problem& part, std::size_t n, const Span& span,
                         const std::vector<Element>& elements, const std::vector<Moved>& moved) {
    const Line& line = part.lines[n];
    Views changing = 0;
    bool moves = false;
    for (std::size_t e = 0; e < elements.size(); ++e) {
        if (is_through_centre(part, n, elements[e])) continue;
        moves = moves || moved[e].lines[n];
        changing |= moved[e].lines[n] ? ~views_that_keep(elements[e]) : elements[e].views;
    }
    int conditions = std::popcount(changing & line.seen_by);
    if (!moves) conditions = conditions_to_keep(span, line, conditions);
    const bool pivots = !part.cameras->all_matrices || span.rank == 3 || meets(span, line);
    return (pivots ? 1 : 2) * conditions;
}

int central_parameters(const Problem& part, const Motion& motion) {
    const std::vector<Element>& elements = motion.elements;
    const Span span = span_of_generators(part, motion);
    Views moving = 0;
    std::vector<Moved> moved;
    for (const Element& element : elements) {
        moving |= element.views;
        moved.push_back(moved_with(part, element, span));
    }
    require_independent(part, elements);
    const int freedom = part.cameras->all_matrices ? 4 - span.rank : 1;
    const int of_space = moving == part.views ? 1 : 0;
    int free = freedom * (static_cast<int>(elements.size()) - of_space);
    for (std::size_t n = 0; n < part.lines.size(); ++n)
        if (!span.lines[n]) free -= conditions_of(part, n, span, elements, moved);
    return free;
}
} // namespace checker
