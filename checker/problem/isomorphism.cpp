#include "checker/problem/isomorphism.h"

#include <algorithm>

namespace checker {
static PointType type_of(const Problem& problem, const Point& point) {
    PointType type{.seen_by = point.seen_by};
    for (const std::size_t n : point.lines)
        type.lines.push_back({problem.lines[n].points.size(), problem.lines[n].seen_by});
    std::ranges::sort(type.lines);
    return type;
}

static std::vector<PointType> types_of(const Problem& problem) {
    std::vector<PointType> types;
    for (const Point& point : problem.points)
        types.push_back(type_of(problem, point));
    return types;
}

Invariant invariant(const Problem& problem) {
    Invariant result{problem.cameras->name, problem.views, types_of(problem), {}};
    std::ranges::sort(result.points);
    for (const Line& line : problem.lines)
        if (line.points.empty()) result.free_lines.push_back(line.seen_by);
    std::ranges::sort(result.free_lines);
    return result;
}

/// Whether some line through all these points has the number of points of `like`, and its views.
static bool have_line(const Problem& problem, const Indices& points, const Line& like) {
    const auto fits = [&](std::size_t n) {
        const Line& line = problem.lines[n];
        const auto is_on = [&](std::size_t p) { return std::ranges::count(line.points, p) > 0; };
        return line.points.size() == like.points.size() && line.seen_by == like.seen_by &&
               std::ranges::all_of(points, is_on);
    };
    return std::ranges::any_of(problem.points[points[0]].lines, fits);
}

/// A renaming of the points of a problem as those of another, while it is being found.
struct Search {
    const Problem& from;
    const Problem& to;
    std::vector<PointType> from_types;
    std::vector<PointType> to_types;
    Indices image{}; // of the first points
};

/// Whether the lines through the last point that has an image keep their points. The lines of equal
/// types are equally many, and two points have one line at most: so each line gets another image.
static bool keeps_lines(const Search& search) {
    const std::size_t last = search.image.size() - 1;
    for (const std::size_t n : search.from.points[last].lines) {
        const Line& line = search.from.lines[n];
        Indices images;
        for (const std::size_t p : line.points)
            if (p <= last) images.push_back(search.image[p]);
        if (!have_line(search.to, images, line)) return false;
    }
    return true;
}

/// Tries all images of the next point.
static bool extend(Search& search) {
    const std::size_t next = search.image.size();
    if (next == search.from.points.size()) return true;
    for (std::size_t p = 0; p < search.to.points.size(); ++p) {
        if (search.to_types[p] != search.from_types[next]) continue;
        if (std::ranges::count(search.image, p) > 0) continue;
        search.image.push_back(p);
        if (keeps_lines(search) && extend(search)) return true;
        search.image.pop_back();
    }
    return false;
}

bool isomorphic(const Problem& a, const Problem& b) {
    Search search{a, b, types_of(a), types_of(b)};
    return extend(search);
}
} // namespace checker
