"""Section 13: why a problem in general is not minimal: parts and their motions."""

from cameras import dimension
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


def by_directions(problem, part, words, joins):
    cameras, (views, points, lines) = cameras_of(problem, part, words), part
    require(cameras != "projective", "directions of projective cameras")
    require(all(len(points & set(problem.on[j])) <= 1 for j in lines), "a line with two points")
    trees = {i: {i} for i in points}
    for a, b in joins:
        require(a in points and b in points and trees[a] is not trees[b], "joins")
        trees[a] |= trees[b]
        trees.update({i: trees[a] for i in trees[a]})
    return beyond_two([problem.lines[j] & views for j in lines] +
                      [problem.points[a] & problem.points[b] & views for a, b in joins]) - \
        (dimension(cameras, len(views)) - 3 * len(views) + 4)


def by_pencils(problem, part, words, centre):
    cameras, (views, points, lines) = cameras_of(problem, part, words), part
    require(cameras == "projective" and centre in points and views <= problem.points[centre] and
            all(points & set(problem.on[j]) == {centre} for j in lines), "no pencils")
    return beyond_two([problem.lines[j] & views for j in lines] +
                      [problem.points[i] & views for i in points - {centre}]) - \
        (5 * len(views) - 8)


def conditions(problem, part, words, motion):
    """How many conditions the images of the part satisfy: Y' - X' - D' + κ."""
    cameras, (views, points, lines) = cameras_of(problem, part, words), part
    projective = cameras == "projective"
    space, seen = problem.dimensions(points, lines, views)
    due = seen - space - dimension(cameras, len(views))
    if motion is None:
        return due
    centre, moving, *given = motion
    star = centre is not None
    require(moving <= views and given[0] <= points and given[1] <= lines and
            (not star or centre in points), "a motion of other views, points or lines")
    on = {j: [i for i in problem.on[j] if i in points] for j in lines}
    rank, points_within, lines_within = span(on, *given)
    require(rank <= 3 and (projective or not any(given)), "no such motion")
    costing = [j for j in lines - lines_within
               if problem.lines[j] & moving and centre not in on[j]]
    counting = {i for i in points if problem.points[i] & moving or any(i in on[j] for j in costing)}
    require(counting <= points_within | {centre}, "a point that counts is not in W")
    scale = 3 if not star else 4 - rank if projective else 1
    gained = {0: 4 if not star else scale, 1: 0 if star else 1}.get(len(views - moving), 0)
    once = not star or not projective or rank == 3
    cost = sum((1 if once or points_within & set(on[j]) else 2) *
               min(len(problem.lines[j] & moving), max(0, len(problem.lines[j] & views) - 2))
               for j in costing)
    return due + scale * len(moving) - gained - cost
