#include "prover/minimal/reason.h"

#include "prover/minimal/joined_points.h"

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

std::string numbers_from_one(const std::vector<int>& numbers) {
    std::string text;
    for (const int number : numbers)
        text += ' ' + std::to_string(number + 1);
    return text.empty() ? " -" : text;
}

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

/// Whether the core is a part of the part, and each point of the part on a line of it is in it.
static bool is_core(const Problem& problem, const Subproblem& part, const Subproblem& core) {
    const auto has = [](const std::vector<int>& all, const std::vector<int>& some) {
        return std::ranges::includes(all, some);
    };
    const bool whole_lines = std::ranges::all_of(core.lines, [&](int number) {
        const Line& line = problem.lines[static_cast<std::size_t>(number)];
        return std::ranges::all_of(line.points, [&](int point) {
            return is_in(core.points, point) || !is_in(part.points, point);
        });
    });
    return (core.views & ~part.views) == 0 && std::popcount(core.views) >= 2 &&
           has(part.points, core.points) && has(part.lines, core.lines) && whole_lines &&
           is_part(problem, core);
}

/// How many of these points a view sees.
static int count_seen(const Problem& problem, const std::vector<int>& points, int view) {
    return static_cast<int>(std::ranges::count_if(points, [&](int point) {
        return contains(problem.points[static_cast<std::size_t>(point)], view);
    }));
}

/// What a view without a translation says of directions in the core: of its lines, and of joins
/// between points that no line joins.
static int directions_of_core(const Problem& problem, const Subproblem& core, int view) {
    int lines = 0, unjoined = count_seen(problem, core.points, view);
    for (const int number : core.lines) {
        const Line& line = problem.lines[static_cast<std::size_t>(number)];
        if (contains(line.seen, view)) ++lines;
        std::vector<int> points = line.points;
        std::erase_if(points, [&](int point) { return !is_in(core.points, point); });
        unjoined -= std::max(0, count_seen(problem, points, view) - 1);
    }
    return lines + std::max(0, unjoined - 1);
}

/// Joins the points of each of these lines that are in the part; false if that closes a circle.
static bool join_along(JoinedPoints& joined, const Problem& problem, const Subproblem& part,
                       const std::vector<int>& lines) {
    for (const int number : lines) {
        std::vector<int> points = problem.lines[static_cast<std::size_t>(number)].points;
        std::erase_if(points, [&](int point) { return !is_in(part.points, point); });
        for (std::size_t i = 1; i < points.size(); ++i)
            if (!joined.join(points[0], points[i])) return false;
    }
    return true;
}

/// Whether lines and joins close no circle: those of the core, and all others, the core taken for
/// one point.
static bool is_forest(const Problem& problem, const Subproblem& part, const CameraMotion& motion) {
    const Subproblem& core = motion.core;
    JoinedPoints joined(problem.points.size());
    if (!join_along(joined, problem, part, core.lines)) return false;
    for (const int point : core.points)
        joined.join(point, core.points.front());
    std::vector<int> others;
    std::ranges::set_difference(part.lines, core.lines, std::back_inserter(others));
    return join_along(joined, problem, part, others) &&
           std::ranges::all_of(motion.joins,
                               [&](const auto& join) { return joined.join(join[0], join[1]); });
}

/// What the images say of directions, less the parameters of these and of cameras without their
/// translations; of the core with its translations. A line of the part joins its points.
static std::optional<int> excess_of_directions(const Problem& problem, const Subproblem& part,
                                               const CameraMotion& motion) {
    const Problem alone = problem_of(problem, part);
    if (alone.cameras->all_matrices) return std::nullopt;
    if (!is_forest(problem, part, motion)) return std::nullopt;
    const Subproblem& core = motion.core;
    if (core.views != 0 && !is_core(problem, part, core)) return std::nullopt;
    int result = 3 * alone.views - 4 - alone.cameras->dimension(alone.views);
    for (const int number : part.lines)
        if (!is_in(core.lines, number))
            result +=
                conditions_in(problem.lines[static_cast<std::size_t>(number)].seen & part.views);
    for (const auto& [a, b] : motion.joins)
        result += conditions_in(problem.points[static_cast<std::size_t>(a)] &
                                problem.points[static_cast<std::size_t>(b)] & part.views);
    if (core.views == 0) return result;
    const Problem scene = problem_of(problem, core);
    result += dimension_in_views(scene) - dimension_in_space(scene) - (3 * scene.views - 4);
    for (int view = 0; view < problem.views; ++view)
        if (contains(part.views & ~core.views, view))
            result += directions_of_core(problem, core, view);
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
