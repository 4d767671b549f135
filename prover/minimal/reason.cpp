#include "prover/minimal/reason.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace plprove {

namespace {

bool is_in(const std::vector<int>& ascending, int number) {
    return std::ranges::binary_search(ascending, number);
}

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

/// Whether each point that a moving view sees, or that lies on a costly line, is kept.
bool keeps_points(const Problem& problem, const Subproblem& part, const CameraMotion& motion,
                  const Span& span, const std::vector<int>& costly) {
    return std::ranges::all_of(part.points, [&](int point) {
        const bool is_centre = motion.kind == MotionKind::star && point == motion.centre;
        if (is_centre || span.has_point(point)) return true;
        const bool on_costly_line = std::ranges::any_of(costly, [&](int number) {
            return contains(problem.lines[static_cast<std::size_t>(number)], point);
        });
        return (problem.points[static_cast<std::size_t>(point)] & motion.moving) == 0 &&
               !on_costly_line;
    });
}

/// What views say of a line, beyond the two numbers of its direction.
int conditions_in(ViewSet views) {
    return std::max(0, std::popcount(views) - 2);
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

Subproblem whole(const Problem& problem) {
    Subproblem part{all_views(problem.views), {}, {}};
    part.points.resize(problem.points.size());
    part.lines.resize(problem.lines.size());
    std::iota(part.points.begin(), part.points.end(), 0);
    std::iota(part.lines.begin(), part.lines.end(), 0);
    return part;
}

Problem problem_of(const Problem& problem, const Subproblem& part) {
    std::vector<int> views;
    for (int view = 0; view < problem.views; ++view)
        if (contains(part.views, view)) views.push_back(view);
    const auto seen_in_part = [&](ViewSet seen) {
        ViewSet result = 0;
        for (std::size_t i = 0; i < views.size(); ++i)
            if (contains(seen, views[i])) result |= ViewSet{1} << i;
        return result;
    };
    Problem result{problem.cameras, static_cast<int>(views.size()), {}, {}};
    for (const int point : part.points)
        result.points.push_back(seen_in_part(problem.points[static_cast<std::size_t>(point)]));
    for (const int number : part.lines) {
        const Line& line = problem.lines[static_cast<std::size_t>(number)];
        Line kept{{}, seen_in_part(line.seen)};
        for (std::size_t i = 0; i < part.points.size(); ++i)
            if (contains(line, part.points[i])) kept.points.push_back(static_cast<int>(i));
        result.lines.push_back(kept);
    }
    return result;
}

bool is_part(const Problem& problem, const Subproblem& part) {
    std::vector<bool> points(problem.points.size(), true), lines(problem.lines.size(), true);
    const auto leave_out_some = [&] {
        bool changed = false;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const bool goes = lines[i] && !is_in(part.lines, static_cast<int>(i)) &&
                              marked_points(problem.lines[i], points) <= 2;
            if (goes) lines[i] = false;
            changed = changed || goes;
        }
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!points[i] || is_in(part.points, static_cast<int>(i))) continue;
            const auto through =
                std::ranges::count_if(lines_through(problem, static_cast<int>(i)), [&](int number) {
                    return lines[static_cast<std::size_t>(number)];
                });
            if (through > 2) continue;
            points[i] = false;
            changed = true;
        }
        return changed;
    };
    while (leave_out_some()) {
    }
    return std::ranges::count(points, true) == std::ssize(part.points) &&
           std::ranges::count(lines, true) == std::ssize(part.lines);
}

std::optional<int> motions(const Problem& problem, const Subproblem& part,
                           const CameraMotion& motion) {
    if (motion.kind == MotionKind::none) return 0;
    const CameraModel& cameras = *problem.cameras;
    const Span span = spanned_by(problem, part, motion);
    if (span.rank() > (cameras.all_matrices ? 3 : 0)) return std::nullopt;
    const std::vector<int> costly = costly_lines(problem, part, motion, span);
    if (!keeps_points(problem, part, motion, span, costly)) return std::nullopt;
    const int resting = std::popcount(part.views & ~motion.moving);
    const Freedom free = freedom(*problem.cameras, motion, span.rank(), resting);
    int result = free.camera * std::popcount(motion.moving) - free.space;
    for (const int number : costly) {
        const Line& line = problem.lines[static_cast<std::size_t>(number)];
        const bool pivots = motion.kind == MotionKind::plane || !cameras.all_matrices ||
                            span.rank() == 3 || span.meets(line);
        const int moving = std::popcount(line.seen & motion.moving);
        result -= (pivots ? 1 : 2) * std::min(moving, conditions_in(line.seen & part.views));
    }
    return result;
}

/// What the images say of directions, less the parameters of these and of cameras without their
/// translations. Lines of the part may have one point at most.
static std::optional<int> excess_of_directions(const Problem& problem, const Subproblem& part,
                                               const CameraMotion& motion) {
    const Problem alone = problem_of(problem, part);
    if (alone.cameras->all_matrices) return std::nullopt;
    int result = 3 * alone.views - 4 - alone.cameras->dimension(alone.views);
    for (const Line& line : alone.lines) {
        if (line.points.size() > 1) return std::nullopt;
        result += conditions_in(line.seen);
    }
    for (const auto& [a, b] : motion.joins)
        result += conditions_in(problem.points[static_cast<std::size_t>(a)] &
                                problem.points[static_cast<std::size_t>(b)] & part.views);
    return result;
}

/// What the images say of the lines through a point that all views of the part see, and of its
/// joins with the other points, less the parameters of these and of their maps to pencils.
static std::optional<int> excess_of_pencils(const Problem& problem, const Subproblem& part,
                                            const CameraMotion& motion) {
    const auto seen = [&](int point) {
        return problem.points[static_cast<std::size_t>(point)] & part.views;
    };
    if (!problem.cameras->all_matrices || seen(motion.centre) != part.views) return std::nullopt;
    int result = 8 - 5 * std::popcount(part.views);
    for (const int number : part.lines) {
        const Line& line = problem.lines[static_cast<std::size_t>(number)];
        for (const int point : part.points)
            if (contains(line, point) != (point == motion.centre)) return std::nullopt;
        result += conditions_in(line.seen & part.views);
    }
    for (const int point : part.points)
        if (point != motion.centre) result += conditions_in(seen(point));
    return result;
}

std::optional<int> excess(const Problem& problem, const Subproblem& part,
                          const CameraMotion& motion) {
    if (motion.projective) {
        if (problem.cameras->all_matrices) return std::nullopt;
        Problem projective = problem;
        projective.cameras = &projective_cameras;
        CameraMotion of_these = motion;
        of_these.projective = false;
        return excess(projective, part, of_these);
    }
    if (motion.kind == MotionKind::directions) return excess_of_directions(problem, part, motion);
    if (motion.kind == MotionKind::pencils) return excess_of_pencils(problem, part, motion);
    const std::optional<int> kept = motions(problem, part, motion);
    if (!kept) return std::nullopt;
    const Problem alone = problem_of(problem, part);
    return dimension_in_views(alone) - dimension_in_space(alone) -
           alone.cameras->dimension(alone.views) + *kept;
}

} // namespace plprove
