#!/usr/bin/env python3
"""Lists the problems of each family a second time, and computes each rank a second time.

    tests/families/ranks.py PLPROVE FAMILY...

Nothing is shared with plprove: arrangements are sets of lines up to permutations of points, cameras are
K [R | t] with the calibration matrix itself (plprove has rotations of a conic), all of them free, and
J is taken modulo 2^61 - 1 at one random point. A problem is minimal if the rank of J is the number of
its rows. Of each family the problems by views, free and dependent points, free lines and pins, and how
many of these are minimal, must be those that `plprove list --family` prints.
"""
import collections
import csv
import io
import itertools
import random
import subprocess
import sys

Q = 2**61 - 1
MOST_VIEWS = 12

# What is unknown: axes to turn about, numbers of K that all cameras share, numbers of K of each camera.
Family = collections.namedtuple("Family", "axes shared own")
FAMILIES = {
    "plmp": Family(3, 0, 0),
    "shared-focal": Family(3, 1, 0),
    "focal": Family(3, 0, 1),
    "shared-focal-center": Family(3, 3, 0),
    "shared-k": Family(3, 5, 0),
    "upright": Family(1, 0, 0),
    "upright-shared-focal": Family(1, 1, 0),
    "upright-focal": Family(1, 0, 1),
}
# Where the numbers of K stand: f, the principal point, the other diagonal entry, the skew.
PLACES = [(2, 2), (0, 2), (1, 2), (1, 1), (0, 1)]

# Lines of three points or more, as sorted tuples; the pins of each point; lines without points.
Problem = collections.namedtuple("Problem", "views points lines free_lines pins")


def dimension(family, views):
    """Of all cameras, up to turns about the axes, translations and scalings."""
    return (family.axes + 3 + family.own) * views + family.shared - (family.axes + 4)


def construction(points, lines):
    """The points in an order in which each lies on at most one line with two earlier ones, or None."""
    left, rest, order = set(range(points)), [set(line) for line in lines], []
    while left:
        last = [p for p in left if sum(p in line and len(line) >= 3 for line in rest) <= 1]
        if not last:
            return None
        order.append(min(last))
        left.discard(order[-1])
        for line in rest:
            line.discard(order[-1])
    return order[::-1]


def renamed(lines, names):
    return tuple(sorted(tuple(sorted(names[p] for p in line)) for line in lines))


def canonical(points, lines):
    """The least of all renamings. Points on no line keep the last names."""
    used = sorted({p for line in lines for p in line})
    others = [p for p in range(points) if p not in used]
    kinds = dict.fromkeys(used, ())
    for _ in range(2):  # a point by the lines through it, and these by the points on them
        kinds = {p: tuple(sorted(tuple(sorted(kinds[q] for q in line)) for line in lines if p in line))
                 for p in used}
    groups = [[p for p in used if kinds[p] == kind] for kind in sorted(set(kinds.values()))]
    return min(renamed(lines, {p: i for i, p in enumerate(itertools.chain(*order, others))})
               for order in itertools.product(*map(itertools.permutations, groups)))


def arrangements(points):
    """The ways in which points lie on lines of three points or more, up to renaming."""
    candidates = [line for size in range(3, points + 1)
                  for line in itertools.combinations(range(points), size)]
    level, found = {()}, [()]
    while level:
        level = {canonical(points, lines + (line,)) for lines in level for line in candidates
                 if all(len(set(line) & set(other)) <= 1 for other in lines)
                 and construction(points, lines + (line,))}
        found += sorted(level)
    return found


def distributions(count, bins):
    """All ways to put so many equal things into bins."""
    if bins == 0:
        return [()] if count == 0 else []
    return [(first,) + rest for first in range(count + 1)
            for rest in distributions(count - first, bins - 1)]


def pinned(points, lines, pins):
    """One of each class of ways to distribute pins."""
    symmetries = [names for names in itertools.permutations(range(points))
                  if renamed(lines, names) == renamed(lines, range(points))]
    return {max(tuple(way[names[p]] for p in range(points)) for names in symmetries)
            for way in distributions(pins, points)}


def problems(family):
    """All balanced ones."""
    known = {}
    for views in range(2, MOST_VIEWS + 1):
        most = dimension(family, views)
        for points in range(most + 1):
            if views == 2 and (points != most or most > 7):
                continue  # lines say nothing in two views; their matrix F has seven parameters
            most_dependent = max(0, points - 2)
            if most + 3 * points - 2 * most_dependent < views * (2 * points - most_dependent):
                continue  # the images of the points alone have too many
            for lines in known.setdefault(points, arrangements(points)):
                # Each view gives 2 points - d + 2 f + a; space has 3 points - 2 d + 4 f + 2 a.
                d = sum(len(line) - 2 for line in lines)
                missing = most + 3 * points - 2 * d - views * (2 * points - d)
                if views == 2:
                    yield Problem(views, points, lines, 0, (0,) * points)
                    continue
                if missing < 0 or missing % (views - 2):
                    continue
                for free_lines in range(missing // (views - 2) // 2 + 1):
                    pins = missing // (views - 2) - 2 * free_lines
                    for way in pinned(points, lines, pins):
                        yield Problem(views, points, lines, free_lines, way)


class Vector:
    """A vector of space and its derivatives by the unknowns, {number: vector}."""

    def __init__(self, value, slopes):
        self.value, self.slopes = value, slopes


class Point:
    """A random point of the domain: scene and cameras, with the unknowns numbered as they come."""

    def __init__(self, family, problem):
        self.random, self.unknowns = random.Random(1), 0
        self.points, self.order = {}, construction(problem.points, problem.lines)
        for p in self.order:
            carriers = [[a for a in line if a in self.points] for line in problem.lines if p in line]
            carrier = next((line for line in carriers if len(line) >= 2), None)
            self.points[p] = self.on(*(self.points[a] for a in carrier[:2])) if carrier else self.vector()
        self.lines = [(self.points[p], self.vector(), True)
                      for p in range(problem.points) for _ in range(problem.pins[p])]
        self.lines += [(self.vector(), self.vector(), False) for _ in range(problem.free_lines)]
        shared = self.numbers(family.shared)
        self.cameras = [self.camera(family, shared or self.numbers(family.own))
                        for _ in range(problem.views)]

    def number(self):
        return self.random.randrange(Q)

    def numbers(self, count):
        """Unknown ones: [(value, number of the unknown)]."""
        self.unknowns += count
        return [(self.number(), self.unknowns - count + i) for i in range(count)]

    def vector(self):
        numbers = self.numbers(3)
        return Vector([value for value, _ in numbers],
                      {unknown: [int(i == j) for j in range(3)] for i, (_, unknown) in enumerate(numbers)})

    def on(self, a, b):
        """A point on the line through two."""
        (s, unknown), = self.numbers(1)
        slopes = {k: [(1 - s) * x for x in slope] for k, slope in a.slopes.items()}
        for k, slope in b.slopes.items():
            slopes[k] = [x + s * y for x, y in zip(slopes.get(k, [0, 0, 0]), slope)]
        slopes[unknown] = [y - x for x, y in zip(a.value, b.value)]
        return Vector([x + s * (y - x) for x, y in zip(a.value, b.value)], slopes)

    def camera(self, family, calibration):
        """(K [R | t], {unknown: its derivative})."""
        a, b, c, d = (self.number() for _ in range(4))
        if family.axes == 1:
            b = d = 0
        rows = [[a*a + b*b - c*c - d*d, 2*(b*c - a*d), 2*(b*d + a*c)],
                [2*(b*c + a*d), a*a - b*b + c*c - d*d, 2*(c*d - a*b)],
                [2*(b*d - a*c), 2*(c*d + a*b), a*a - b*b - c*c + d*d]]
        pose = [row + [self.number()] for row in rows]
        k = [[int(i == j) for j in range(3)] for i in range(3)]
        slopes = {}
        for (value, unknown), (i, j) in zip(calibration, PLACES):
            k[i][j] = value
            slopes[unknown] = [[x % Q for x in pose[j]] if row == i else [0] * 4 for row in range(3)]
        for axis in range(3) if family.axes == 3 else [1]:
            turned = [[0] * 4 for _ in range(3)]
            after, before = (axis + 1) % 3, (axis + 2) % 3
            turned[after][:3] = [-x for x in pose[before][:3]]
            turned[before][:3] = pose[after][:3]
            (_, unknown), = self.numbers(1)
            slopes[unknown] = product(k, turned)
        for i in range(3):
            (_, unknown), = self.numbers(1)
            slopes[unknown] = product(k, [[0, 0, 0, int(row == i)] for row in range(3)])
        return product(k, pose), slopes


def product(a, b):
    return [[sum(x * row[j] for x, row in zip(line, b)) % Q for j in range(len(b[0]))] for line in a]


def image(camera, x, weight):
    return [(sum(m * y for m, y in zip(row, x)) + weight * row[3]) % Q for row in camera]


def jacobian(family, problem):
    """The rows: l . d(P X) for each line l of the image through the image of X."""
    at = Point(family, problem)
    rows = []

    def add(l, camera, slopes, x, weight):
        row = [0] * at.unknowns
        pulled = [sum(l[i] * camera[i][j] for i in range(3)) for j in range(3)]
        for unknown, slope in x.slopes.items():
            row[unknown] = sum(p * y for p, y in zip(pulled, slope)) % Q
        for unknown, slope in slopes.items():
            row[unknown] = sum(p * y for p, y in zip(l, image(slope, x.value, weight))) % Q
        rows.append(row)

    for camera, slopes in at.cameras:
        seen = set()
        for p in at.order:
            x = image(camera, at.points[p].value, 1)
            add([0, x[2], -x[1]], camera, slopes, at.points[p], 1)
            if not any(p in line and len(seen & set(line)) >= 2 for line in problem.lines):
                add([-x[2], 0, x[0]], camera, slopes, at.points[p], 1)
            seen.add(p)
        for start, direction, has_point in at.lines:
            a, e = image(camera, start.value, 1), image(camera, direction.value, 0)
            l = [a[1]*e[2] - a[2]*e[1], a[2]*e[0] - a[0]*e[2], a[0]*e[1] - a[1]*e[0]]
            if not has_point:
                add(l, camera, slopes, start, 1)
            add(l, camera, slopes, direction, 0)
    return rows


def rank(rows):
    """Modulo Q."""
    found = 0
    for column in range(len(rows[0])):
        pivot = next((i for i in range(found, len(rows)) if rows[i][column]), None)
        if pivot is None:
            continue
        rows[found], rows[pivot] = rows[pivot], rows[found]
        inverse = pow(rows[found][column], -1, Q)
        for row in rows[found + 1:]:
            if row[column]:
                factor = row[column] * inverse % Q
                for j in range(column, len(row)):
                    row[j] = (row[j] - factor * rows[found][j]) % Q
        found += 1
    return found


def counted(family):
    """{views, free and dependent points, free lines, pins, minimal: how many problems}."""
    counts = collections.Counter()
    for problem in problems(family):
        rows = jacobian(family, problem)
        dependent = sum(len(line) - 2 for line in problem.lines)
        counts[problem.views, problem.points - dependent, dependent, problem.free_lines,
               sum(problem.pins), int(rank(rows) == len(rows))] += 1
    return counts


def listed(plprove, name):
    """The same by plprove."""
    text = subprocess.run([plprove, "list", "--family", name, "--format", "csv"], check=True,
                          capture_output=True, text=True).stdout
    return collections.Counter(tuple(map(int, line[:6])) for line in csv.reader(io.StringIO(text))
                               if line[0].isdigit())


def main():
    plprove, *names = sys.argv[1:]
    status = 0
    for name in names or FAMILIES:
        ours, theirs = counted(FAMILIES[name]), listed(plprove, name)
        minimal = sum(count for key, count in ours.items() if key[-1])
        print(f"{name}: {sum(ours.values())} balanced, {minimal} minimal:",
              "the same" if ours == theirs else f"plprove differs: {ours - theirs} {theirs - ours}")
        status = status or int(ours != theirs)
    sys.exit(status)


if __name__ == "__main__":
    main()
