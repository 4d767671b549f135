#include "checker/reasons/motions.h"

#include <algorithm>
#include <functional>
#include <map>

namespace checker {
/// The W of an element, what moves with it, and in which views it changes the image of each line.
struct Moved {
    Span span{};
    std::vector<bool> points{};
    std::vector<bool> lines{};
    std::vector<Views> changes{};
};

/// Whether the element moves the line in itself: one in W, through the centre, or the axis.
static bool keeps(const Problem& part, const Element& element, const Span& span, std::size_t n) {
    using enum Element::Centre;
    if (element.kind == point && contains(part.lines[n].points, element.centre)) return true;
    return span.lines[n] || ((element.kind == line || element.kind == axis) && element.centre == n);
}

/// What moves: points that moving views see, but those in W, the centre and those on the axis;
/// lines with such a point, and lines that only these views see, with all such points on them.
/// Throws Refused if another view sees such a point.
static Moved moved_with(const Problem& part, const Element& element) {
    using enum Element::Centre;
    const Views centre = element.kind == view ? Views{1} << element.centre : 0;
    if ((element.moved.views & centre) != 0) throw Refused("a view moves about its own centre");
    const Views keeping = element.moved.views | centre;
    const std::size_t lines = part.lines.size();
    Moved moved{span_of_generators(part, element.moved), std::vector<bool>(part.points.size()),
                std::vector<bool>(lines), std::vector<Views>(lines)};
    const auto is_fixed = [&](std::size_t p) {
        if (element.kind == axis) return contains(part.lines[element.centre].points, p);
        return moved.span(p) || (element.kind == point && element.centre == p);
    };
    for (std::size_t p = 0; p < part.points.size(); ++p)
        moved.points[p] = count_seen(part, {p}, element.moved.views) > 0 && !is_fixed(p);
    const auto moves = [&](std::size_t p) { return moved.points[p]; };
    const auto may_move = [&](std::size_t p) {
        return is_fixed(p) || (part.points[p].seen_by & ~keeping) == 0;
    };
    for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t n = 0; n < lines; ++n) {
            const Line& line = part.lines[n];
            if (moved.lines[n] || keeps(part, element, moved.span, n)) continue;
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
    for (std::size_t n = 0; n < lines; ++n)
        if (!keeps(part, element, moved.span, n))
            moved.changes[n] = moved.lines[n] ? ~keeping : element.moved.views;
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

/// The conditions on the elements that change the image of a line in some of these views, so that
/// it stays in one where all do: two, or one if a point of the line rests there anyway.
static int conditions_in_one(const Problem& part, std::size_t n, const std::vector<Moved>& elements,
                             Views views) {
    std::vector<Span> kept;
    Indices resting = part.lines[n].points;
    for (const Moved& moved : elements) {
        if ((moved.changes[n] & views) == 0) continue;
        kept.push_back(moved.span);
        std::erase_if(resting, [&](std::size_t p) { return !moved.span.points[p]; });
    }
    if (kept.empty()) return 0;
    const bool plane = kept[0].rank == 3 && std::ranges::count(kept, kept[0]) == std::ssize(kept);
    return part.cameras->all_matrices && !plane && resting.empty() ? 2 : 1;
}

/// The conditions so that the images of a line stay. A line that may move alone takes all but those
/// beyond its own parameters.
static int conditions_of(const Problem& part, std::size_t n, const std::vector<Moved>& elements) {
    const Line& line = part.lines[n];
    int conditions = 0;
    for (Views view = 1; view <= line.seen_by; view <<= 1)
        conditions += conditions_in_one(part, n, elements, view & line.seen_by);
    const auto leaves_alone = [&](const Moved& moved) {
        const bool pivots = std::ranges::all_of(line.points, std::cref(moved.span));
        return !moved.lines[n] && ((moved.changes[n] & line.seen_by) == 0 || pivots);
    };
    if (!std::ranges::all_of(elements, leaves_alone)) return conditions;
    const int in_one = conditions_in_one(part, n, elements, line.seen_by);
    return std::min(conditions, in_one * conditions_in(line.seen_by));
}

int central_parameters(const Problem& part, const std::vector<Element>& elements) {
    Views moving = 0;
    int free = 0, of_space = 4; // which is the least of an element about a point
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
