#include "checker/reasons/motions.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace checker {
/// Points that are joined, one after the other, without a circle.
class Forest {
public:
    explicit Forest(std::size_t points) : tree_(points) {
        std::iota(tree_.begin(), tree_.end(), std::size_t{0});
    }

    /// Takes some points for one.
    void unite(const Indices& points) {
        for (const std::size_t p : points)
            connect(p, points[0]);
    }

    /// Joins each of the points to the first. Throws Refused if two were joined before.
    void join(std::span<const std::size_t> points) {
        for (std::size_t i = 1; i < points.size(); ++i)
            if (!connect(points[i], points[0])) throw Refused("lines and joins close a circle");
    }

private:
    /// False if the two are connected already.
    bool connect(std::size_t a, std::size_t b) {
        const std::size_t of_a = tree_[a], of_b = tree_[b];
        std::ranges::replace(tree_, of_a, of_b);
        return of_a != of_b;
    }

    Indices tree_;
};

/// Throws Refused if the lines of the core close a circle, each as joins of its points; or the
/// other lines and the joins, the core taken for one point.
static void require_forest(const Problem& part, const Motion& motion) {
    Forest forest(part.points.size());
    for (const std::size_t n : motion.core.lines)
        forest.join(part.lines[n].points);
    forest.unite(motion.core.points);
    for (std::size_t n = 0; n < part.lines.size(); ++n)
        if (!contains(motion.core.lines, n)) forest.join(part.lines[n].points);
    for (std::size_t i = 0; i < motion.joins.size(); i += 2)
        forest.join(std::span(motion.joins).subspan(i, 2));
}

/// Throws Refused unless the core is a part of the part, with the points on its lines.
static void require_core(const Problem& part, const Selection& core) {
    if (!arises(part, core)) throw Refused("the core does not arise by leaving out");
    for (const std::size_t n : core.lines)
        for (const std::size_t p : part.lines[n].points)
            if (!contains(core.points, p))
                throw Refused("line ", n + 1, " of the part is in the core, point ", p + 1,
                              " on it is not");
}

/// Y - X of the core.
static int excess_of_scene(const Problem& part, const Selection& core) {
    const Problem alone = part_of(part, core);
    return surplus(alone) + camera_columns(alone);
}

/// What a view outside the core says of directions in it: of its lines, and of joins that connect
/// those points that it sees and no line connects.
static int directions_seen(const Problem& part, const Selection& core, Views view) {
    int lines = 0, unconnected = count_seen(part, core.points, view);
    for (const std::size_t n : core.lines) {
        if ((part.lines[n].seen_by & view) != 0) ++lines;
        unconnected -= std::max(0, count_seen(part, part.lines[n].points, view) - 1);
    }
    return lines + std::max(0, unconnected - 1);
}

/// What is left over when the directions of lines and joins are counted, and the cameras without
/// their translations; of the core also positions and translations.
int excess_of_directions(const Problem& part, const Motion& motion) {
    const auto& [core_views, core_points, core_lines] = motion.core;
    if (part.cameras->all_matrices) throw Refused("projective cameras have no `directions`");
    int excess = 3 * part.view_count() - 4 - camera_columns(part);
    for (std::size_t n = 0; n < part.lines.size(); ++n)
        if (!contains(core_lines, n)) excess += conditions_in(part.lines[n].seen_by);
    require_forest(part, motion);
    for (std::size_t i = 0; i < motion.joins.size(); i += 2)
        excess += conditions_in(part.points[motion.joins[i]].seen_by &
                                part.points[motion.joins[i + 1]].seen_by);
    if (core_views == 0) return excess;
    require_core(part, motion.core);
    for (Views rest = part.views & ~core_views; rest != 0; rest &= rest - 1)
        excess += directions_seen(part, motion.core, rest & (~rest + 1)); // the lowest view
    return excess + excess_of_scene(part, motion.core) - (3 * std::popcount(core_views) - 4);
}

/// What is left over when the lines from a point are counted, three in a plane if their points are
/// on a line, and what each view makes of them: a pencil, by a map that has five numbers.
int excess_of_pencils(const Problem& part, std::size_t centre) {
    if (!part.cameras->all_matrices)
        throw Refused(part.cameras->name, " cameras have no `pencils`");
    if (part.points[centre].seen_by != part.views)
        throw Refused("a view of the part does not see the point of the pencils");
    int excess = 8 - 5 * part.view_count();
    const auto is_shared = [&](std::size_t p) {
        return std::popcount(part.points[p].seen_by) >= 2;
    };
    for (const Line& line : part.lines) {
        const bool apart = !contains(line.points, centre);
        if (!apart && line.points.size() > 1) throw Refused("a line joins the point and another");
        const auto shared = std::ranges::count_if(line.points, is_shared);
        excess += apart ? std::max(0, static_cast<int>(shared) - 2) : conditions_in(line.seen_by);
    }
    for (std::size_t p = 0; p < part.points.size(); ++p)
        if (p != centre) excess += conditions_in(part.points[p].seen_by);
    return excess;
}
} // namespace checker
