#include "prover/reasons/motion.h"

#include <algorithm>
#include <bit>

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

Span spanned_by(const Problem& problem, const Subproblem& part, const CameraMotion& motion) {
    Span span(problem, part);
    for (const int point : motion.points)
        span.add_point(point);
    for (const int line : motion.lines)
        span.add_line(line);
    return span;
}

/// The lines whose images the moving cameras would change, if the scene were at rest.
std::vector<int> costly_lines(const Problem& problem, const Subproblem& part,
                              const CameraMotion& motion, const Span& span) {
    std::vector<int> costly;
    for (const int number : part.lines) {
        const Line& line = problem.lines[static_cast<std::size_t>(number)];
        const bool through_centre =
            motion.kind == MotionKind::star && contains(line, motion.centre);
        if (!span.has_line(number) && !through_centre && (line.seen & motion.moving) != 0)
            costly.push_back(number);
    }
    return costly;
}

/// Whether the motion keeps the images of a point, and the point.
bool keeps(const CameraMotion& motion, const Span& span, int point) {
    return span.has_point(point) || (motion.kind == MotionKind::star && point == motion.centre);
}

/// Whether each point that a moving view sees is kept.
bool keeps_points(const Problem& problem, const Subproblem& part, const CameraMotion& motion,
                  const Span& span) {
    return std::ranges::all_of(part.points, [&](int point) {
        return keeps(motion, span, point) ||
               (problem.points[static_cast<std::size_t>(point)] & motion.moving) == 0;
    });
}

/// Motions of one camera, and those of space among the motions of all.
struct Freedom {
    int camera = 0;
    int space = 0;
};

Freedom freedom(const CameraModel& model, const CameraMotion& motion, int rank, int resting) {
    if (motion.kind == MotionKind::plane) {
        if (resting == 0) return {3, 4};
        return {3, resting == 1 ? 1 : 0};
    }
    const int camera = model.all_matrices ? 4 - rank : 1;
    return {camera, resting == 0 ? camera : 0};
}

} // namespace

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
    if (!in_part || (motion.points.size() != 1 && motion.lines.size() != 1)) return std::nullopt;
    int result = 0;
    for (const int point : motion.points) {
        int resting_lines = 0;
        for (const int number : lines_through(problem, point))
            if (is_in(part.lines, number) && !is_in(motion.lines, number)) ++resting_lines;
        if (resting_lines > 1) return std::nullopt;
        result += 3 - 2 * resting_lines - (2 - resting_lines) * std::popcount(seen(point));
    }
    for (const int number : motion.lines) {
        const Line& line = line_at(number);
        int resting = 0, loose = 0, loose_and_seen = 0;
        for (const int point : line.points) {
            if (!is_in(part.points, point)) continue;
            ++(is_loose(point) ? loose : resting);
            if (is_loose(point)) loose_and_seen += std::popcount(line.seen & seen(point));
        }
        const bool star =
            std::ranges::all_of(motion.points, [&](int point) { return contains(line, point); });
        if (resting > 1 || !star) return std::nullopt;
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

/// Motions of space that keep one camera, if it alone of those that rest sees something that moves:
/// all that moving views see, and what is joined to it by incidence.
static std::optional<int> motions_apart(const Problem& problem, const Subproblem& part,
                                        const CameraMotion& motion) {
    const ViewSet resting = part.views & ~motion.moving;
    if (motion.moving == 0 || (motion.moving & ~part.views) != 0 || std::popcount(resting) < 2)
        return std::nullopt;
    std::vector<bool> points(problem.points.size()), lines(problem.lines.size());
    const auto line_moves = [&](int number) {
        const Line& line = problem.lines[static_cast<std::size_t>(number)];
        return (line.seen & motion.moving) != 0 || std::ranges::any_of(line.points, [&](int point) {
                   return is_in(part.points, point) && points[static_cast<std::size_t>(point)];
               });
    };
    const auto point_moves = [&](int point) {
        return (problem.points[static_cast<std::size_t>(point)] & motion.moving) != 0 ||
               std::ranges::any_of(lines_through(problem, point), [&](int number) {
                   return is_in(part.lines, number) && lines[static_cast<std::size_t>(number)];
               });
    };
    const auto spread = [](std::vector<bool>& all, const std::vector<int>& of_part,
                           const auto& moves) {
        bool changed = false;
        for (const int number : of_part) {
            if (all[static_cast<std::size_t>(number)] || !moves(number)) continue;
            all[static_cast<std::size_t>(number)] = changed = true;
        }
        return changed;
    };
    while (spread(points, part.points, point_moves) || spread(lines, part.lines, line_moves)) {
    }
    ViewSet seeing = 0;
    for (const int point : part.points)
        if (points[static_cast<std::size_t>(point)])
            seeing |= problem.points[static_cast<std::size_t>(point)];
    for (const int number : part.lines)
        if (lines[static_cast<std::size_t>(number)])
            seeing |= problem.lines[static_cast<std::size_t>(number)].seen;
    if (std::popcount(seeing & resting) > 1) return std::nullopt;
    return problem.cameras->all_matrices ? 4 : 1;
}

Subproblem kept_part(const Problem& problem, Subproblem part, const CameraMotion& motion) {
    const Span span = spanned_by(problem, part, motion);
    std::erase_if(part.points, [&](int point) {
        return (problem.points[static_cast<std::size_t>(point)] & motion.moving) != 0 &&
               !keeps(motion, span, point);
    });
    return part;
}

std::optional<int> motions(const Problem& problem, const Subproblem& part,
                           const CameraMotion& motion) {
    if (motion.kind == MotionKind::none) return 0;
    if (motion.kind == MotionKind::loose) return loose_motions(problem, part, motion);
    if (motion.kind == MotionKind::camera) return camera_motions(problem, part, motion);
    if (motion.kind == MotionKind::apart) return motions_apart(problem, part, motion);
    const CameraModel& cameras = *problem.cameras;
    const Span span = spanned_by(problem, part, motion);
    if (span.rank() > (cameras.all_matrices ? 3 : 0)) return std::nullopt;
    if (!keeps_points(problem, part, motion, span)) return std::nullopt;
    const int resting = std::popcount(part.views & ~motion.moving);
    const Freedom free = freedom(*problem.cameras, motion, span.rank(), resting);
    int result = free.camera * std::popcount(motion.moving) - free.space;
    for (const int number : costly_lines(problem, part, motion, span)) {
        const Line& line = problem.lines[static_cast<std::size_t>(number)];
        const bool pivots = motion.kind == MotionKind::plane || !cameras.all_matrices ||
                            span.rank() == 3 || span.meets(line);
        // The line moves, too, unless a point that is not kept would move with it.
        const bool may_move = std::ranges::all_of(line.points, [&](int point) {
            return !is_in(part.points, point) || keeps(motion, span, point);
        });
        const int moving = std::popcount(line.seen & motion.moving);
        const int conditions =
            may_move ? std::min(moving, conditions_in(line.seen & part.views)) : moving;
        result -= (pivots ? 1 : 2) * conditions;
    }
    return result;
}

} // namespace plprove
