#include "checker/reasons/motions.h"

#include <algorithm>

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

/// Whether the centre lies on the line: then the element moves the line in itself.
static bool is_through_centre(const Problem& part, std::size_t line, const Element& element) {
    if (element.kind == Element::Centre::line) return element.centre == line;
    return element.kind == Element::Centre::point &&
           contains(part.lines[line].points, element.centre);
}

/// What moves: points that moving views see, but those in W and the centre; lines with such a
/// point, and lines that only these views see, with all points on them that are not in W. Throws
/// Refused if another view sees such a point.
static Moved moved_with(const Problem& part, const Element& element, const Span& span) {
    const Views keeping = views_that_keep(element);
    Moved moved{std::vector<bool>(part.points.size()), std::vector<bool>(part.lines.size())};
    for (std::size_t p = 0; p < part.points.size(); ++p) {
        const bool is_centre = element.kind == Element::Centre::point && element.centre == p;
        const bool is_seen = (part.points[p].seen_by & element.views) != 0;
        moved.points[p] = is_seen && !span.points[p] && !is_centre;
    }
    const auto moves = [&](std::size_t p) { return moved.points[p]; };
    const auto may_move = [&](std::size_t p) {
        return span.points[p] || (part.points[p].seen_by & ~keeping) == 0;
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
                moved.points[p] = !span.points[p];
        }
    }
    for (std::size_t p = 0; p < part.points.size(); ++p)
        if (moves(p) && !may_move(p))
            throw Refused("the motion does not keep the image of point ", p + 1, " of the part");
    return moved;
}

/// Throws Refused unless different parameters are different motions of cameras: a view belongs to
/// one element about a point and one other at most; and two views rest, or move about the same
/// point alone.
static void require_independent(const Problem& part, const std::vector<Element>& elements) {
    const std::size_t none = part.points.size();
    std::array<std::size_t, most_views> point{};
    std::array<bool, most_views> other{};
    point.fill(none);
    for (const Element& element : elements)
        for (std::size_t view = 0; view < most_views; ++view) {
            if ((element.views >> view & 1) == 0) continue;
            const bool about_point = element.kind == Element::Centre::point;
            if (about_point ? point[view] != none : other[view])
                throw Refused("view ", view + 1, " belongs to two elements of a kind");
            if (about_point) point[view] = element.centre;
            other[view] = other[view] || !about_point;
        }
    for (std::size_t v = 0; v < most_views; ++v)
        for (std::size_t w = 0; w < v; ++w) {
            const bool in_part = (part.views >> v & part.views >> w & 1) != 0;
            const bool alike = point[v] == point[w] || point[v] == none || point[w] == none;
            if (in_part && alike && !other[v] && !other[w]) return;
        }
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
