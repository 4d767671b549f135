#include "checker/reasons/motions.h"

#include <algorithm>
#include <map>

namespace checker {
/// What an element keeps, its W, and what moves with it.
struct Moved {
    const Element& element;
    Span span{};
    std::vector<bool> points{};
    std::vector<bool> lines{};
};

/// The views in which the image of what moves with the element stays.
static Views views_that_keep(const Element& element) {
    if (element.kind != Element::Centre::view) return element.moved.views;
    const Views centre = Views{1} << element.centre;
    if ((element.moved.views & centre) != 0) throw Refused("a view moves about its own centre");
    return element.moved.views | centre;
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
static Moved moved_with(const Problem& part, const Element& element) {
    const Views keeping = views_that_keep(element);
    const Span span = span_of_generators(part, element.moved);
    const auto is_fixed = [&](std::size_t p) {
        using enum Element::Centre;
        if (element.kind == axis) return contains(part.lines[element.centre].points, p);
        return span.points[p] || (element.kind == point && element.centre == p);
    };
    Moved moved{element, span, std::vector<bool>(part.points.size()),
                std::vector<bool>(part.lines.size())};
    for (std::size_t p = 0; p < part.points.size(); ++p)
        moved.points[p] = count_seen(part, {p}, element.moved.views) > 0 && !is_fixed(p);
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
            if (element.moved.views == part.views) throw Refused("no view rests");
            return;
        }
        Views& such = element.kind == point ? about_points : others;
        if (const Views twice = such & element.moved.views; twice != 0)
            throw Refused("view ", std::countr_zero(twice) + 1,
                          " belongs to two elements of a kind");
        such |= element.moved.views;
        if (element.kind == point) about[element.centre] |= element.moved.views;
    }
    int together = 0; // plain views that move about the same point
    for (const auto& [centre, views] : about)
        together = std::max(together, std::popcount(views & ~others));
    if (std::popcount(part.views & ~others & ~about_points) + together < 2)
        throw Refused("no two views rest, or move about the same point alone");
}

/// The views in which an element changes the image of the line.
static Views views_that_change(const Problem& part, std::size_t n, const Moved& moved) {
    const Element& element = moved.element;
    if (moved.span.lines[n] || is_through_centre(part, n, element)) return 0;
    return moved.lines[n] ? ~views_that_keep(element) : element.moved.views;
}

using Spans = std::vector<const Span*>; // of some elements

static bool lies_in_all(const Spans& spans, std::size_t point) {
    return std::ranges::all_of(spans, [&](const Span* span) { return span->points[point]; });
}

/// The conditions on these elements so that the image of a line stays in a view, where each of them
/// changes it: two, or one if a point of the line rests there anyway.
static int conditions_in_view(const Problem& part, const Line& line, const Spans& spans) {
    if (spans.empty()) return 0;
    const auto is_the_plane = [&](const Span* span) {
        return span->rank == 3 && *span == *spans.front();
    };
    const auto rests = [&](std::size_t p) { return lies_in_all(spans, p); };
    const bool pivots = !part.cameras->all_matrices || std::ranges::all_of(spans, is_the_plane) ||
                        std::ranges::any_of(line.points, rests);
    return pivots ? 1 : 2;
}

/// The conditions so that the images of a line stay. A line that may move alone takes all but those
/// beyond its own parameters.
static int conditions_of(const Problem& part, std::size_t n, const std::vector<Moved>& elements) {
    const Line& line = part.lines[n];
    Spans of_all;
    int conditions = 0;
    for (Views view = 1; view <= line.seen_by; view <<= 1) {
        Spans changing;
        for (const Moved& moved : elements)
            if ((views_that_change(part, n, moved) & line.seen_by & view) != 0)
                changing.push_back(&moved.span);
        conditions += conditions_in_view(part, line, changing);
        of_all.insert(of_all.end(), changing.begin(), changing.end());
    }
    const auto moves_it = [&](const Moved& moved) { return moved.lines[n]; };
    const auto rests = [&](std::size_t p) { return lies_in_all(of_all, p); };
    const bool alone = std::ranges::none_of(elements, moves_it);
    if (!alone || !std::ranges::all_of(line.points, rests)) return conditions;
    return std::min(conditions,
                    conditions_in_view(part, line, of_all) * conditions_in(line.seen_by));
}

int central_parameters(const Problem& part, const std::vector<Element>& elements) {
    Views moving = 0;
    int free = 0;
    int of_space = 4; // the least of elements about points
    std::vector<Moved> moved;
    for (const Element& element : elements) {
        moving |= element.moved.views;
        moved.push_back(moved_with(part, element));
        const int own = part.cameras->all_matrices ? 4 - moved.back().span.rank : 1;
        free += own;
        if (element.kind == Element::Centre::point) of_space = std::min(of_space, own);
    }
    require_independent(part, elements);
    if (moving == part.views) free -= of_space;
    for (std::size_t n = 0; n < part.lines.size(); ++n)
        free -= conditions_of(part, n, moved);
    return free;
}
} // namespace checker
