"""Section 13: why a problem in general is not minimal: parts and their motions."""

from cameras import dimension, unknowns_of_one
from grammar import require


def arises(problem, points, lines):
    """Whether the part of these points and lines arises by leaving out one after the other."""
    left_points, left_lines = set(range(len(problem.points))), set(range(len(problem.lines)))
    while True:
        out = {j for j in left_lines - lines if len(left_points & set(problem.on[j])) <= 2}
        left_lines -= out
        point = next((i for i in left_points - points
                      if sum(i in problem.on[j] for j in left_lines) <= 2), None)
        if point is None and not out:
            return left_points == points and left_lines == lines
        left_points.discard(point)


def span(on, points_given, lines_given):
    """(rank, points in W, lines in W); `on` has the points of each line of the part."""
    points, lines, rank = set(), set(), 0

    def close():
        for _ in on:
            lines.update(j for j in on if len(points & set(on[j])) >= 2)
            points.update(i for j in lines for i in on[j])

    for i in sorted(points_given):
        rank += i not in points
        points.add(i)
        close()
    for j in sorted(lines_given):
        rank += 0 if j in lines else 1 if points & set(on[j]) else 2
        lines.add(j)
        close()
    return rank, points, lines


def cameras_of(problem, part, words):
    """The cameras as the motion takes them, once the part is one."""
    _, points, lines = part
    require(arises(problem, points, lines), "what is left out of the part")
    require("projective" not in words or not problem.projective, "the cameras are projective")
    return "projective" if "projective" in words else problem.cameras


def beyond_two(views_of_each):
    return sum(max(0, len(views) - 2) for views in views_of_each)


class Trees:
    """Points that edges connect without a circle."""

    def __init__(self, points):
        self.tree = {i: {i} for i in points}

    def unite(self, points):
        """Takes some points for one; returns whether no two were connected."""
        trees = {id(self.tree[i]): self.tree[i] for i in points}
        union = set().union(*trees.values())
        self.tree.update({i: union for i in union})
        return len(trees) == len(points)


def require_core(problem, part, core):
    (views, points, lines), (core_views, core_points, core_lines) = part, core
    require(core_views <= views and core_points <= points and core_lines <= lines and
            arises(problem, core_points, core_lines), "the core is no part of the part")
    require(all(points & set(problem.on[j]) <= core_points for j in core_lines),
            "a point on a line of the core")


def by_directions(problem, part, words, joins, core):
    cameras, (views, points, lines) = cameras_of(problem, part, words), part
    require(cameras != "projective", "directions of projective cameras")
    core_views, core_points, core_lines = core or (set(), set(), set())
    trees, on = Trees(points), {j: points & set(problem.on[j]) for j in lines}
    require(all(trees.unite(on[j]) for j in core_lines), "a circle of the core")
    trees.unite(core_points)
    require(all(trees.unite(on[j]) for j in lines - core_lines) and
            all(a in points and b in points and trees.unite({a, b}) and a != b for a, b in joins),
            "a circle of lines and joins")
    found = beyond_two([problem.lines[j] & views for j in lines - core_lines] +
                       [problem.points[a] & problem.points[b] & views for a, b in joins]) - \
        (dimension(cameras, len(views)) - 3 * len(views) + 4)
    if not core:
        return found
    require_core(problem, part, core)
    space, seen = problem.dimensions(core_points, core_lines, core_views)
    found += seen - space - (3 * len(core_views) - 4)
    for view in views - core_views:
        seen = {i for i in core_points if view in problem.points[i]}
        connected = sum(max(0, len(seen & on[j]) - 1) for j in core_lines)
        found += sum(view in problem.lines[j] for j in core_lines) + \
            max(0, len(seen) - connected - 1)
    return found


def by_pencils(problem, part, words, centre):
    cameras, (views, points, lines) = cameras_of(problem, part, words), part
    require(cameras == "projective" and centre in points and views <= problem.points[centre] and
            all(points & set(problem.on[j]) == {centre} for j in lines), "no pencils")
    return beyond_two([problem.lines[j] & views for j in lines] +
                      [problem.points[i] & views for i in points - {centre}]) - \
        (5 * len(views) - 8)


def loose(problem, part, loose_points, loose_lines):
    """The kappa of points and lines that move while all else rests."""
    views, points, lines = part
    require(loose_points <= points and loose_lines <= lines, "loose: not in the part")
    on = {j: points & set(problem.on[j]) for j in lines}
    require((len(loose_points) == 1 or len(loose_lines) == 1) and
            all(loose_points <= on[j] for j in loose_lines), "loose: neither point nor line")
    found = 0
    for i in loose_points:
        resting = sum(i in on[j] for j in lines - loose_lines)
        require(resting < 2, "a loose point on two lines that rest")
        found += 3 - 2 * resting - (2 - resting) * len(problem.points[i] & views)
    for j in loose_lines:
        resting, seen = len(on[j] - loose_points), problem.lines[j] & views
        require(resting < 2, "a loose line with two points that rest")
        found += 4 - 2 * len(on[j]) - (2 - resting) * len(seen)
        found += sum(len(seen & problem.points[i]) for i in loose_points)
    return found


def one_camera(problem, cameras, part, view):
    """The kappa of a camera that moves alone."""
    views, points, lines = part
    require(view in views and len(views) > 2, "camera: too few views")
    seen = {i for i in points if view in problem.points[i]}
    beyond_three = sum(max(0, len(seen & set(problem.on[j])) - 3) for j in lines)
    return unknowns_of_one(cameras) - problem.dimensions(points, lines, {view})[1] + beyond_three


def apart(problem, cameras, part, moving):
    """The kappa of views that move with all that they see."""
    views, points, lines = part
    require(moving <= views and len(views - moving) > 1, "apart: too few views rest")
    moved = {("point", i) for i in points if problem.points[i] & moving} | \
        {("line", j) for j in lines if problem.lines[j] & moving}
    while True:
        more = {found for j in lines for i in points & set(problem.on[j])
                for found in (("point", i), ("line", j)) if {("point", i), ("line", j)} & moved}
        if more <= moved:
            break
        moved |= more
    seeing = set().union(*((problem.points if kind == "point" else problem.lines)[n]
                           for kind, n in moved))
    require(len(seeing & (views - moving)) < 2, "two views that rest see what moves")
    return 4 if cameras == "projective" else 1


def conditions(problem, part, words, motion):
    """How many conditions the images of the part satisfy: Y' - X' - D' + κ."""
    cameras, (views, points, lines) = cameras_of(problem, part, words), part
    projective = cameras == "projective"
    space, seen = problem.dimensions(points, lines, views)
    due = seen - space - dimension(cameras, len(views))
    if motion is None:
        return due
    if "loose" in words:
        return due + loose(problem, part, *motion)
    if "apart" in words:
        return due + apart(problem, cameras, part, motion)
    if "camera" in words:
        return due + one_camera(problem, cameras, part, *motion)
    centre, moving, *given = motion
    star = centre is not None
    require(moving <= views and given[0] <= points and given[1] <= lines and
            (not star or centre in points), "a motion of other views, points or lines")
    on = {j: [i for i in problem.on[j] if i in points] for j in lines}
    rank, points_within, lines_within = span(on, *given)
    require(rank <= 3 and (projective or not any(given)), "no such motion")
    costing = [j for j in lines - lines_within
               if problem.lines[j] & moving and centre not in on[j]]
    kept = points_within | {centre}
    require({i for i in points if problem.points[i] & moving} <= kept, "a point is not in W")
    scale = 3 if not star else 4 - rank if projective else 1
    gained = {0: 4 if not star else scale, 1: 0 if star else 1}.get(len(views - moving), 0)
    once = not star or not projective or rank == 3
    cost = sum((1 if once or points_within & set(on[j]) else 2) *
               min(len(problem.lines[j] & moving),
                   max(0, len(problem.lines[j] & views) - 2) if kept.issuperset(on[j]) else 12)
               for j in costing)
    return due + scale * len(moving) - gained - cost
