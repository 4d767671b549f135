#include "prover/reasons/motion.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace plprove {

namespace {

/// Of the line's points, how many are marked.
int marked_points(const Line& line, const std::vector<bool>& marked) {
    return static_cast<int>(std::ranges::count_if(
        line.points, [&](int x) { return marked[static_cast<std::size_t>(x)]; }));
}

/// A subspace spanned by points and lines: what lies in it, and a bound for its rank.
class Span {
public:
    Span(const Problem& problem, const Subproblem& part)
        : problem_(problem), part_(part), points_(problem.points.size(), false),
          lines_(problem.lines.size(), false) {}

    int rank() const { return rank_; }
    bool has_point(int point) const { return points_[static_cast<std::size_t>(point)]; }
    bool has_line(int line) const { return lines_[static_cast<std::size_t>(line)]; }
    bool meets(const Line& line) const { return marked_points(line, points_) > 0; }
    bool is_same_plane(const Span& other) const {
        return rank_ == 3 && other.rank_ == 3 && points_ == other.points_ && lines_ == other.lines_;
    }

    void add_point(int point) {
        if (has_point(point)) return;
        points_[static_cast<std::size_t>(point)] = true;
        rank_ += 1;
        close();
    }

    void add_line(int number) {
        if (has_line(number)) return;
        rank_ += meets(problem_.lines[static_cast<std::size_t>(number)]) ? 1 : 2;
        lines_[static_cast<std::size_t>(number)] = true;
        close();
    }

private:
    void close() {
        for (bool changed = true; changed;) {
            changed = false;
            for (const int number : part_.lines)
                changed = close_line(number) || changed;
        }
    }

    /// A line with two points of the span is in it, and so are all points of a line in it.
    bool close_line(int number) {
        const Line& line = problem_.lines[static_cast<std::size_t>(number)];
        const bool in_span = has_line(number) || marked_points(line, points_) >= 2;
        if (!in_span) return false;
        bool changed = !has_line(number);
        lines_[static_cast<std::size_t>(number)] = true;
        for (const int point : line.points) {
            if (has_point(point) || !is_in(part_.points, point)) continue;
            points_[static_cast<std::size_t>(point)] = true;
            changed = true;
        }
        return changed;
    }

    const Problem& problem_;
    const Subproblem& part_;
    std::vector<bool> points_;
    std::vector<bool> lines_;
    int rank_ = 0;
};

/// The span of the generators of a motion; of one of its elements, together with its own.
Span spanned_by(const Problem& problem, const Subproblem& part, const CameraMotion& motion,
                const CentralElement& element = {}) {
    Span span(problem, part);
    for (const int point : united(motion.points, element.points))
        span.add_point(point);
    for (const int line : united(motion.lines, element.lines))
        span.add_line(line);
    return span;
}

/// Whether W contains all points of the part on a line.
bool contains_points(const Span& span, const Subproblem& part, const Line& line) {
    return std::ranges::all_of(line.points, [&](int point) {
        return span.has_point(point) || !is_in(part.points, point);
    });
}

/// Motions of cameras that keep the images of W and have three parameters each.
std::optional<int> plane_motions(const Problem& problem, const Subproblem& part,
                                 const CameraMotion& motion) {
    const Span span = spanned_by(problem, part, motion);
    if (span.rank() > (problem.cameras->all_matrices ? 3 : 0)) return std::nullopt;
    for (const int point : part.points)
        if (!span.has_point(point) &&
            (problem.points[static_cast<std::size_t>(point)] & motion.moving) != 0)
            return std::nullopt;
    constexpr std::array of_space{4, 1}; // if no camera rests, or one
    const auto resting = static_cast<std::size_t>(std::popcount(part.views & ~motion.moving));
    int result = 3 * std::popcount(motion.moving);
    if (resting < of_space.size()) result -= of_space[resting];
    for (const int number : part.lines) {
        const Line& line = problem.lines[static_cast<std::size_t>(number)];
        if (span.has_line(number)) continue;
        const int moving = std::popcount(line.seen & motion.moving);
        result -= contains_points(span, part, line)
                      ? std::min(moving, conditions_in(line.seen & part.views))
                      : moving;
    }
    return result;
}

/// What an element moves, and which views see none of it change.
class Carried {
public:
    Carried(const Problem& problem, const Subproblem& part, Span span,
            const CentralElement& element)
        : problem_(problem), part_(part), span_(std::move(span)), element_(element),
          keeping_(element.views |
                   (element.kind == CentralElement::Centre::view ? ViewSet{1} << element.centre
                                                                 : ViewSet{0})),
          points_(problem.points.size(), false), lines_(problem.lines.size(), false) {
        for (const int point : part.points) {
            if ((seen(point) & element.views) != 0) carry(point);
        }
        for (bool changed = true; changed;) {
            changed = false;
            for (const int number : part.lines)
                changed = carry_line(number) || changed;
        }
    }

    /// The views that see a point that moves.
    ViewSet seeing_points() const {
        ViewSet result = 0;
        for (const int point : part_.points)
            if (points_[static_cast<std::size_t>(point)]) result |= seen(point);
        return result;
    }
    ViewSet keeping() const { return keeping_; }
    const Span& span() const { return span_; }
    bool has_line(int number) const { return lines_[static_cast<std::size_t>(number)]; }
    /// The views of the part in which the element changes the image of a line.
    ViewSet changing(int number) const {
        if (span_.has_line(number) || passes_centre(number)) return 0;
        const ViewSet seen = problem_.lines[static_cast<std::size_t>(number)].seen & part_.views;
        return seen & (has_line(number) ? static_cast<ViewSet>(~keeping_) : element_.views);
    }

private:
    bool passes_centre(int number) const {
        return ((element_.kind == CentralElement::Centre::line ||
                 element_.kind == CentralElement::Centre::axis) &&
                element_.centre == number) ||
               (element_.kind == CentralElement::Centre::point &&
                contains(problem_.lines[static_cast<std::size_t>(number)], element_.centre));
    }
    ViewSet seen(int point) const {
        return problem_.points[static_cast<std::size_t>(point)] & part_.views;
    }
    /// Whether the point lies in W, or is the centre or on the axis.
    bool is_fixed(int point) const {
        if (element_.kind == CentralElement::Centre::axis)
            return contains(problem_.lines[static_cast<std::size_t>(element_.centre)], point);
        return span_.has_point(point) ||
               (element_.kind == CentralElement::Centre::point && element_.centre == point);
    }
    void carry(int point) {
        if (!is_fixed(point)) points_[static_cast<std::size_t>(point)] = true;
    }
    /// A line moves with a point of it, or alone if no other view sees anything of it.
    bool carry_line(int number) {
        if (has_line(number) || span_.has_line(number) || passes_centre(number)) return false;
        const Line& line = problem_.lines[static_cast<std::size_t>(number)];
        bool moves = false, alone = (line.seen & part_.views & ~keeping_) == 0;
        for (const int point : line.points) {
            if (!is_in(part_.points, point)) continue;
            moves = moves || points_[static_cast<std::size_t>(point)];
            alone = alone && (is_fixed(point) || (seen(point) & ~keeping_) == 0);
        }
        if (!moves && !alone) return false;
        lines_[static_cast<std::size_t>(number)] = true;
        for (const int point : line.points)
            if (is_in(part_.points, point)) carry(point);
        return true;
    }

    const Problem& problem_;
    const Subproblem& part_;
    Span span_;
    const CentralElement& element_;
    ViewSet keeping_;
    std::vector<bool> points_;
    std::vector<bool> lines_;
};

/// Whether different parameters of the elements are different motions: a view has one element about
/// a point and one other at most, and two views rest, or move about the same point alone. An
/// element with an axis is alone, and a view rests.
bool are_independent(const Problem& problem, const Subproblem& part,
                     const std::vector<CentralElement>& elements) {
    ViewSet about_points = 0, others = 0;
    for (const CentralElement& element : elements) {
        if (element.kind == CentralElement::Centre::axis)
            return problem.cameras->may_turn && elements.size() == 1 &&
                   element.views != part.views && (element.views & ~part.views) == 0;
        ViewSet& such = element.kind == CentralElement::Centre::point ? about_points : others;
        if ((such & element.views) != 0 || (element.views & ~part.views) != 0) return false;
        if (element.kind == CentralElement::Centre::view && contains(element.views, element.centre))
            return false;
        such |= element.views;
    }
    const ViewSet plain = part.views & ~others;
    const int resting = std::popcount(plain & ~about_points);
    if (resting >= 2) return true;
    return std::ranges::any_of(elements, [&](const CentralElement& element) {
        if (element.kind != CentralElement::Centre::point) return false;
        ViewSet alike = 0;
        for (const CentralElement& other : elements)
            if (other.kind == element.kind && other.centre == element.centre) alike |= other.views;
        return resting + std::popcount(plain & alike) >= 2;
    });
}

/// The elements that change the image of a line, in one view or in any.
using Changing = std::vector<const Carried*>;

/// Whether they all keep the point.
bool keep_point(const Changing& elements, int point) {
    return std::ranges::all_of(
        elements, [&](const Carried* element) { return element->span().has_point(point); });
}

/// How many conditions on the elements keep the image of a line in a view, where they change it.
int conditions_in_a_view(const Problem& problem, const Line& line, const Subproblem& part,
                         const Changing& elements) {
    if (elements.empty()) return 0;
    const bool share_plane = std::ranges::all_of(elements, [&](const Carried* element) {
        return element->span().is_same_plane(elements.front()->span());
    });
    const bool share_point = std::ranges::any_of(line.points, [&](int point) {
        return is_in(part.points, point) && keep_point(elements, point);
    });
    return !problem.cameras->all_matrices || share_plane || share_point ? 1 : 2;
}

/// How many conditions keep the images of a line, which may move by itself if no element moves it.
int conditions_on(const Problem& problem, const Subproblem& part, int number,
                  const std::vector<Carried>& elements) {
    const Line& line = problem.lines[static_cast<std::size_t>(number)];
    const ViewSet seen = line.seen & part.views;
    ViewSet changing = 0;
    Changing all;
    for (const Carried& element : elements) {
        if (element.changing(number) != 0) all.push_back(&element);
        changing |= element.changing(number);
    }
    int conditions = 0;
    for (ViewSet view = 1; view <= changing; view <<= 1) {
        Changing here;
        for (const Carried* element : all)
            if ((element->changing(number) & view) != 0) here.push_back(element);
        conditions += conditions_in_a_view(problem, line, part, here);
    }
    const bool moves = std::ranges::any_of(
        elements, [&](const Carried& element) { return element.has_line(number); });
    const bool pivots = std::ranges::all_of(line.points, [&](int point) {
        return keep_point(all, point) || !is_in(part.points, point);
    });
    if (moves || !pivots) return conditions;
    return std::min(conditions,
                    conditions_in_a_view(problem, line, part, all) * conditions_in(seen));
}

/// The parameters of the elements, less what space contributes, and less the conditions so that the
/// images of lines stay.
std::optional<int> central_motions(const Problem& problem, const Subproblem& part,
                                   const CameraMotion& motion) {
    const bool projective = problem.cameras->all_matrices;
    if (!are_independent(problem, part, motion.elements)) return std::nullopt;
    std::vector<Carried> carried;
    int result = 0, of_space = 4; // of space: the least of elements about points
    for (const CentralElement& element : motion.elements) {
        carried.emplace_back(problem, part, spanned_by(problem, part, motion, element), element);
        const int rank = carried.back().span().rank();
        if (rank > (projective ? 3 : 0)) return std::nullopt;
        if ((carried.back().seeing_points() & ~carried.back().keeping()) != 0) return std::nullopt;
        const int free = projective ? 4 - rank : 1;
        result += free;
        if (element.kind == CentralElement::Centre::point) of_space = std::min(of_space, free);
    }
    if (moving_views(motion) == part.views) result -= of_space;
    for (const int number : part.lines)
        result -= conditions_on(problem, part, number, carried);
    return result;
}

} // namespace

CameraMotion star(int point, ViewSet moving) {
    CameraMotion motion{.kind = MotionKind::central};
    for (int view = 0; ViewSet{1} << view <= moving; ++view)
        if (contains(moving, view))
            motion.elements.push_back({.centre = point, .views = ViewSet{1} << view});
    return motion;
}

std::optional<int> point_of_star(const CameraMotion& motion) {
    if (motion.kind != MotionKind::central || motion.elements.empty()) return std::nullopt;
    const int point = motion.elements.front().centre;
    const bool is_star = motion.elements == star(point, moving_views(motion)).elements;
    return is_star ? std::optional(point) : std::nullopt;
}

ViewSet moving_views(const CameraMotion& motion) {
    ViewSet views = motion.moving;
    for (const CentralElement& element : motion.elements)
        views |= element.views;
    return views;
}

std::vector<CentralElement> elements_about(const Problem& problem, const Subproblem& part,
                                           const CameraMotion& generators,
                                           CentralElement::Centre kind, int centre) {
    const Span span = spanned_by(problem, part, generators);
    const ViewSet itself = kind == CentralElement::Centre::view ? ViewSet{1} << centre : ViewSet{0};
    std::vector<CentralElement> found;
    ViewSet left = part.views & ~itself;
    while (left != 0) {
        CentralElement element{kind, centre, left & (~left + 1)}; // the first that is left
        for (ViewSet before = 0; before != element.views;) {
            before = element.views;
            element.views |= Carried(problem, part, span, element).seeing_points() & ~itself;
        }
        found.push_back(element);
        left &= ~element.views;
    }
    return found;
}

/// The parameters of a point with some lines through it, or of a line with some of its points, less
/// the equations by which views keep their images while all else is at rest.
static std::optional<int> loose_motions(const Problem& problem, const Subproblem& part,
                                        const CameraMotion& motion) {
    const auto line_at = [&](int number) -> const Line& {
        return problem.lines[static_cast<std::size_t>(number)];
    };
    const auto is_loose = [&](int point) { return is_in(motion.points, point); };
    const auto seen = [&](int point) {
        return problem.points[static_cast<std::size_t>(point)] & part.views;
    };
    const bool in_part = std::ranges::includes(part.points, motion.points) &&
                         std::ranges::includes(part.lines, motion.lines);
    if (!in_part) return std::nullopt;
    int result = 0;
    std::vector<int> loose_lines_through(problem.points.size());
    for (const int point : motion.points) {
        int resting_lines = 0;
        for (const int number : lines_through(problem, point))
            if (is_in(motion.lines, number))
                ++loose_lines_through[static_cast<std::size_t>(point)];
            else if (is_in(part.lines, number))
                ++resting_lines;
        if (resting_lines > 1) return std::nullopt;
        result += 3 - 2 * resting_lines - (2 - resting_lines) * std::popcount(seen(point));
    }
    for (const int number : motion.lines) {
        const Line& line = line_at(number);
        int resting = 0, loose = 0, loose_and_seen = 0;
        bool joined = false; // to another line, by a loose point
        for (const int point : line.points) {
            if (!is_in(part.points, point)) continue;
            ++(is_loose(point) ? loose : resting);
            if (is_loose(point)) loose_and_seen += std::popcount(line.seen & seen(point));
            joined = joined || loose_lines_through[static_cast<std::size_t>(point)] > 1;
        }
        if (resting > 1 || (loose > 1 && joined)) return std::nullopt;
        result += 4 - 2 * (resting + loose) -
                  (2 - resting) * std::popcount(line.seen & part.views) + loose_and_seen;
    }
    return result;
}

/// The unknowns of a camera, less the equations by which it keeps its images while all else is at
/// rest. Three points of a line fix the images of all others.
static std::optional<int> camera_motions(const Problem& problem, const Subproblem& part,
                                         const CameraMotion& motion) {
    if (std::popcount(motion.moving) != 1 || std::popcount(part.views) < 3) return std::nullopt;
    Subproblem seen = part;
    seen.views = motion.moving;
    int result = problem.cameras->unknowns - dimension_in_views(problem_of(problem, seen));
    for (const int number : part.lines) {
        const Line& line = problem.lines[static_cast<std::size_t>(number)];
        const auto points = std::ranges::count_if(line.points, [&](int point) {
            return is_in(part.points, point) &&
                   (problem.points[static_cast<std::size_t>(point)] & motion.moving) != 0;
        });
        result += std::max(0, static_cast<int>(points) - 3);
    }
    return result;
}

Subproblem kept_part(const Problem& problem, Subproblem part, const CameraMotion& motion) {
    const Span span = spanned_by(problem, part, motion);
    const std::optional<int> centre = point_of_star(motion);
    std::erase_if(part.points, [&](int point) {
        return (problem.points[static_cast<std::size_t>(point)] & moving_views(motion)) != 0 &&
               !span.has_point(point) && point != centre;
    });
    return part;
}

std::optional<int> motions(const Problem& problem, const Subproblem& part,
                           const CameraMotion& motion) {
    if (motion.kind == MotionKind::none) return 0;
    if (motion.kind == MotionKind::loose) return loose_motions(problem, part, motion);
    if (motion.kind == MotionKind::camera) return camera_motions(problem, part, motion);
    if (motion.kind == MotionKind::plane) return plane_motions(problem, part, motion);
    return central_motions(problem, part, motion);
}

} // namespace plprove
