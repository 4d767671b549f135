"""Section 13: why a problem in general is not minimal: parts and their motions."""

from cameras import TURNING, dimension, unknowns_of_one
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
    on_part = {j: points & set(problem.on[j]) for j in lines}
    require(cameras == "projective" and centre in points and views <= problem.points[centre] and
            all(on == {centre} or centre not in on for on in on_part.values()), "no pencils")
    shared = {i for i in points if len(problem.points[i] & views) > 1}
    flat = sum(max(0, len(on & shared) - 2) for on in on_part.values() if centre not in on)
    return flat + beyond_two([problem.lines[j] & views for j in lines if centre in on_part[j]] +
                      [problem.points[i] & views for i in points - {centre}]) - \
        (5 * len(views) - 8)


def loose(problem, part, loose_points, loose_lines):
    """The kappa of points and lines that move while all else rests."""
    views, points, lines = part
    require(loose_points <= points and loose_lines <= lines, "loose: not in the part")
    on = {j: points & set(problem.on[j]) for j in lines}
    through = {i: sum(i in on[j] for j in loose_lines) for i in loose_points}
    require(all(len(on[j] & loose_points) < 2 or max(through[i] for i in on[j] & loose_points) < 2
                for j in loose_lines), "loose: a point on two lines, and one on one of these")
    found = 0
    for i in loose_points:
        resting = sum(i in on[j] for j in lines - loose_lines)
        require(resting < 2, "a loose point on two lines that rest")
        found += 3 - 2 * resting - (2 - resting) * len(problem.points[i] & views)
    for j in loose_lines:
        resting, seen = len(on[j] - loose_points), problem.lines[j] & views
        require(resting < 2, "a loose line with two points that rest")
        found += 4 - 2 * len(on[j]) - (2 - resting) * len(seen)
        found += sum(len(seen & problem.points[i]) for i in loose_points & on[j])
    return found


def one_camera(problem, cameras, part, view):
    """The kappa of a camera that moves alone."""
    views, points, lines = part
    require(view in views and len(views) > 2, "camera: too few views")
    seen = {i for i in points if view in problem.points[i]}
    beyond_three = sum(max(0, len(seen & set(problem.on[j])) - 3) for j in lines)
    return unknowns_of_one(cameras) - problem.dimensions(points, lines, {view})[1] + beyond_three


def generated(part, on, generators, projective):
    """W: its rank, its points and its lines."""
    _, points, lines = part
    require(generators[0] <= points and generators[1] <= lines, "generators of other points or lines")
    within = span(on, *generators)
    require(within[0] <= 3 and (projective or not any(generators)), "no such generators")
    return within


def plane(problem, part, on, within, moving):
    """The kappa of cameras that keep the points of W."""
    (views, points, lines), (_, points_within, lines_within) = part, within
    require(moving <= views, "a motion of other views")
    require({i for i in points if problem.points[i] & moving} <= points_within, "a point is not in W")
    found = 3 * len(moving) - {0: 4, 1: 1}.get(len(views - moving), 0)
    for j in lines - lines_within:
        changing, may_move = len(problem.lines[j] & moving), points_within.issuperset(on[j])
        found -= min(changing, beyond_two([problem.lines[j] & views])) if may_move else changing
    return found


def moves_with(problem, part, on, within, element):
    """The lines that move with an element; of each line, the views in which it changes the image."""
    (views, points, lines), (_, points_within, lines_within) = part, within
    kind, centre, own, _ = element
    free = points - points_within
    if kind == "axis":
        free -= set(on[centre])
    keeping = own | ({centre} if kind == "view" else set())
    moved = {i for i in free if problem.points[i] & own and (kind, centre) != ("point", i)}
    moved_lines, others = set(), {j for j in lines - lines_within if not holds(element, j, on)}
    while True:
        more = {j for j in others - moved_lines if moved & set(on[j]) or not views & set().union(
            problem.lines[j], *(problem.points[i] for i in free & set(on[j]))) - keeping}
        if not more:
            break
        moved_lines |= more
        moved |= {i for j in more for i in free & set(on[j])}
    require(all(problem.points[i] & views <= keeping for i in moved), "a view sees what moves")
    return moved_lines, {j: problem.lines[j] & views & (views - keeping if j in moved_lines else own)
                         for j in others}


def holds(element, line, on):
    kind, centre, *_ = element
    return kind in ("line", "axis") and centre == line or kind == "point" and centre in on[line]


def require_independent(part, elements, may_turn):
    views, points, lines = part
    among = {"point": points, "line": lines, "view": views, "axis": lines}
    require(all(own <= views and centre in among[kind] and (kind != "view" or centre not in own)
                for kind, centre, own, _ in elements), "an element of other things")
    if any(kind == "axis" for kind, *_ in elements):
        require(len(elements) == 1 and elements[0][2] != views and may_turn, "an axis")
        return
    plain = []
    for view in views:
        kinds = [kind for kind, _, own, _ in elements if view in own]
        about = [centre for kind, centre, own, _ in elements if view in own and kind == "point"]
        require(len(about) < 2 and len(kinds) - len(about) < 2, "a view of two such elements")
        if len(kinds) == len(about):
            plain.append(about)
    require(len(plain) > 1 and ([] in plain or any(plain.count(about) > 1 for about in plain)),
            "no two plain views")


def conditions_in_view(on, withins, projective):
    """The c of the elements with these W, of a line with these points."""
    if not withins:
        return 0
    plane = withins[0][0] == 3 and all(within == withins[0] for within in withins)
    shared = set(on).intersection(*(points for _, points, _ in withins))
    return 2 if projective and not plane and not shared else 1


def central(problem, part, on, elements, projective):
    """The kappa of a central motion."""
    views, points, lines = part
    require_independent(part, elements, not projective and problem.cameras in TURNING)
    withins = [generated(part, on, element[3], projective) for element in elements]
    moved = [moves_with(problem, part, on, within, element)
             for within, element in zip(withins, elements)]
    free = [4 - within[0] if projective else 1 for within in withins]
    found = sum(free)
    if set().union(*(element[2] for element in elements)) == views:
        found -= min(f for f, element in zip(free, elements) if element[0] == "point")
    for j in lines:
        changed = [(within, changes.get(j, set())) for within, (_, changes) in zip(withins, moved)]
        cost = sum(conditions_in_view(on[j], [within for within, change in changed if view in change],
                                      projective) for view in views)
        every = [within for within, change in changed if change]
        if not any(j in moved_lines for moved_lines, _ in moved) and \
                all(set(on[j]) <= points_within for _, points_within, _ in every):
            cost = min(cost, conditions_in_view(on[j], every, projective) *
                       beyond_two([problem.lines[j] & views]))
        found -= cost
    return found


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
    if "camera" in words:
        return due + one_camera(problem, cameras, part, *motion)
    on = {j: [i for i in problem.on[j] if i in points] for j in lines}
    if "plane" in words:
        moving, *generators = motion
        return due + plane(problem, part, on, generated(part, on, generators, projective), moving)
    return due + central(problem, part, on, motion, projective)
