#!/usr/bin/python3
"""The tests of Theorems S and P a second time, from their pages alone (proofs/all_permutations.md
and proofs/five_shared_points.md).

    theorem_s.py PLCHECK CERTS [EVERY]

makes the tests of section 5 for all minimal constraint classes (or the first of each EVERY), and
compares with the groups that plcheck certifies from the classification in the folder CERTS. The
table CERTS/groups.csv must not have another group where the tests succeed.

It shares nothing with checker/. The prime is another one, and so are the places. Derivatives are
those of numbers a + b e with e^2 = 0, along a basis of the motions. Zeros of binary forms are found
by greatest common divisors, not by resultants.
"""

import csv
import json
import random
import subprocess
import sys
from itertools import product

from features import CLASSES, EXCHANGES, FEATURES, SWAPS, largest_form, obstruction

P = 2**59 - 55  # a prime


class Small:
    """a + b e, where e^2 = 0 and b has a number for each of the 12 motions."""

    def __init__(self, value, by=(0,) * 12):
        self.value, self.by = value % P, by

    def __add__(self, other):
        return Small(self.value + other.value, tuple((x + y) % P for x, y in zip(self.by, other.by)))

    def __sub__(self, other):
        return Small(self.value - other.value, tuple((x - y) % P for x, y in zip(self.by, other.by)))

    def __mul__(self, other):
        a, b = self.value, other.value
        return Small(a * b, tuple((a * y + b * x) % P for x, y in zip(self.by, other.by)))

    def along(self, motion):
        return sum(x * y for x, y in zip(self.by, motion)) % P


ZERO = Small(0)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def det(a, b, c):
    return dot(a, cross(b, c))


class Rows:
    """Independent rows modulo P."""

    def __init__(self, rows=()):
        self.rows = list(rows)

    def add(self, row):
        row = list(row)
        for pivot, known in self.rows:
            factor = row[pivot]
            row = [(x - factor * y) % P for x, y in zip(row, known)] if factor else row
        pivot = next((i for i, x in enumerate(row) if x), None)
        if pivot is None:
            return False
        inverse = pow(row[pivot], -1, P)
        self.rows.append((pivot, [x * inverse % P for x in row]))
        return True

    def with_all(self, rows):
        more = Rows(self.rows)
        for row in rows:
            more.add(row)
        return more

    def __len__(self):
        return len(self.rows)

    def motion(self, draw):
        """A random motion that all rows vanish for."""
        motion = [draw() for _ in range(12)]
        for pivot, row in reversed(self.rows):
            motion[pivot] = 0
            motion[pivot] = -sum(x * y for x, y in zip(row, motion)) % P
        return motion


def trimmed(f):
    f = [x % P for x in f]
    while f and not f[-1]:
        f.pop()
    return f


def common_divisor(f, g):
    f, g = trimmed(f), trimmed(g)
    while g:
        inverse = pow(g[-1], -1, P)
        while len(f) >= len(g):
            factor, shift = f[-1] * inverse, len(f) - len(g)
            f = trimmed(x - factor * (g[i - shift] if i >= shift else 0) for i, x in enumerate(f))
        f, g = g, f
    return f


def times(f, g):
    result = [0] * (len(f) + len(g) - 1)
    for i, x in enumerate(f):
        for j, y in enumerate(g):
            result[i + j] += x * y
    return result


def less(f, g):
    return [x - y for x, y in zip(f, g)]


class Place:
    """Three views, their conditions so far, and what is drawn."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.centres = [[Small(x, self.unit(6 + 3 * view - 3 + i) if view else ZERO.by)
                         for i, x in enumerate(self.numbers())] for view in range(3)]
        self.turns = [[Small(0, self.unit(3 * view - 3 + i)) if view else ZERO for i in range(3)]
                      for view in range(3)]
        self.known = Rows()

    @staticmethod
    def unit(place):
        return tuple(int(i == place) for i in range(12))

    def draw(self):
        return self.random.randrange(P)

    def numbers(self):
        return [self.draw() for _ in range(3)]

    def vector(self):
        return [Small(x) for x in self.numbers()]

    def seen(self, view, vector):
        """What rests in the image of a view, in space: it turns with the view."""
        still = [Small(x.value) for x in vector]
        return [x + y for x, y in zip(still, cross(still, self.turns[view]))]

    def ray(self, view, point):
        return self.seen(view, minus(point, self.centres[view]))

    def plane(self, view, point, direction=None):
        """A plane of the view through the point, and parallel to the direction."""
        return self.seen(view, cross(minus(point, self.centres[view]), direction or self.vector()))

    def epipolar(self, i, ray, j, other):
        return det(minus(self.centres[j], self.centres[i]), ray, other)

    def incidence(self, i, ray, j, plane, k, other):
        """The ray meets both planes in the same point."""
        to_plane, to_other = (minus(self.centres[i], self.centres[v]) for v in (j, k))
        return dot(plane, to_plane) * dot(other, ray) - dot(other, to_other) * dot(plane, ray)

    def relative_pose(self, i, j):
        base = minus(self.centres[j], self.centres[i])
        rest = [Small(x.value) for x in base]
        # As view i sees it, where a vector v of space becomes v plus the turn times v.
        direction = [x + y for x, y in zip(base, cross(self.turns[i], base))]
        return [x.by for x in minus(self.turns[j], self.turns[i]) + cross(direction, rest)]

    def keep(self, condition):
        assert condition.value == 0
        return self.known.add(condition.by)

    def cut(self, condition, other):
        """Lemma 2: the other condition has another line through the same point."""
        assert other.value == 0
        two = len(self.known.with_all([condition.by, other.by])) == len(self.known) + 2
        return two and self.keep(condition)

    def general_pin(self, point):
        """Lemma 3."""
        planes = [[self.plane(view, point) for _ in range(2)] for view in range(3)]
        form = {key: det(*(planes[view][key[view]] for view in range(3)))
                for key in product((0, 1), repeat=3)}
        first, *others = form.values()
        ratios = [[(first.value * x - other.value * y) % P for x, y in zip(other.by, first.by)]
                  for other in others]
        if len(self.known.with_all(ratios)) < len(self.known) + 2:
            return False
        motion = self.known.motion(self.draw)

        def linear(b, c, moved):  # in the first direction
            return [form[a, b, c].along(motion) if moved else form[a, b, c].value for a in (0, 1)]

        def minor(b, d):
            return less(times(linear(b, 0, False), linear(d, 1, True)),
                        times(linear(b, 1, False), linear(d, 0, True)))

        middle = [x + y for x, y in zip(minor(0, 1), minor(1, 0))]
        quartic = trimmed(less(times(middle, middle),
                               [4 * x for x in times(minor(0, 0), minor(1, 1))]))
        derivative = [i * x for i, x in enumerate(quartic)][1:]
        return len(quartic) == 5 and len(common_divisor(quartic, derivative)) == 1

    def general_line(self, point, i, j, u, seen):
        """Lemma 4."""
        planes = [[self.plane(v, point) for _ in range(2)] for v in (i, j)]
        form = [[det(planes[0][a], planes[1][b], seen) for b in range(2)] for a in range(2)]
        (a, b), (c, d) = [[x.value for x in row] for row in form]
        if (a * d - b * c) % P == 0:
            return False

        def discriminant(motion):
            (e, f), (g, h) = [[x.along(motion) for x in row] for row in form]
            return (a * h + c * f - b * g - d * e)**2 - 4 * (a * f - b * e) * (c * h - d * g)

        one, two = (self.known.motion(self.draw) for _ in range(2))
        x, y = discriminant(one), discriminant(two)
        mixed = discriminant([s + t for s, t in zip(one, two)]) - x - y
        return (mixed * mixed - 4 * x * y) % P != 0

    def general_matrices(self, i, j, motion):
        """Lemma 6 (i): det(E + t E') has t^2 and t^3, found from its values at 1 and -1."""
        units = [[Small(int(a == b)) for b in range(3)] for a in range(3)]
        entries = [[self.epipolar(i, self.seen(i, x), j, self.seen(j, y)) for y in units]
                   for x in units]

        def determinant(t):
            return det(*([Small(x.value + t * x.along(motion)) for x in row]
                         for row in entries)).value

        plus, less_ = determinant(1), determinant(-1)
        return (plus + less_) % P != 0 and (plus - less_) % P != 0

    def general_tensors(self, i, motion):
        """Lemma 6 (ii): all three minors have no zero in common."""
        j, k = (v for v in range(3) if v != i)
        planes, others = ([self.seen(v, self.vector()) for _ in range(2)] for v in (j, k))
        tensor, moved = [], []
        for t in range(3):
            ray = self.seen(i, [Small(int(t == s)) for s in range(3)])
            (a, b), (c, d) = [[self.incidence(i, ray, j, x, k, y) for y in others] for x in planes]
            form = [a, b + c, d]
            tensor.append([x.value for x in form])
            moved.append([x.along(motion) for x in form])
        minors = [trimmed(less(times(tensor[s], moved[t]), times(tensor[t], moved[s])))
                  for s, t in ((0, 1), (0, 2), (1, 2))]
        divisor = common_divisor(common_divisor(minors[0], minors[1]), minors[2])
        return max(map(len, minors)) == 5 and len(divisor) == 1


def split(feature):
    """(views that see the point, the other ones)"""
    return sorted(feature.point), sorted({0, 1, 2} - feature.point)


def place_first_steps(place, features):
    """Steps 1 to 4. The conditions of each feature, or None if a test fails."""
    features = [f for f in features if f.point is None or len(f.point) != 1]
    rows = []
    lines = []
    for feature in features:
        if feature.point is None:
            point, direction = place.vector(), place.vector()
            normals = [place.plane(v, point, direction) for v in range(3)]
            parallel = place.seen(2, cross(direction, place.vector()))
            pencil = det(*normals)
            if not place.cut(pencil, det(normals[0], normals[1], parallel)):
                return None
            lines.append((point, normals, pencil))
    for point, normals, pencil in lines:
        meet = place.incidence(0, place.ray(0, point), 1, normals[1], 2, normals[2])
        if not place.keep(meet):
            return None
        rows.append([pencil.by, meet.by])
    stars = []
    for feature in features:
        if feature.point == {0, 1, 2}:
            point = place.vector()
            rays = [place.ray(v, point) for v in range(3)]
            conditions = [place.epipolar(0, rays[0], 1, rays[1]),
                          place.epipolar(0, rays[0], 2, rays[2]),
                          place.incidence(0, rays[0], 1, place.plane(1, point), 2,
                                          place.plane(2, point))]
            if not all(map(place.keep, conditions)):
                return None
            rows.append([x.by for x in conditions])
            stars.append((point, rows[-1], len(feature.lines)))
    for point, own, pins in stars:
        for _ in range(pins):
            direction = place.vector()
            pencil = det(*(place.plane(v, point, direction) for v in range(3)))
            if not place.general_pin(point) or not place.keep(pencil):
                return None
            own.append(pencil.by)
    for feature in features:
        if feature.point and len(feature.point) == 2 and feature.lines == (frozenset({0, 1, 2}),):
            (i, j), (u,) = split(feature)
            point, direction = place.vector(), place.vector()
            normals = [place.plane(v, point, direction) for v in range(3)]
            conditions = place_point(place, point, i, j)
            ray, plane = place.ray(i, point), place.plane(j, point)
            meet, other = (place.incidence(i, ray, j, plane, u, normal)
                           for normal in (normals[u], place.plane(u, point)))
            pencil = det(*normals)
            if not (conditions and place.cut(meet, other)
                    and place.general_line(point, i, j, u, normals[u]) and place.keep(pencil)):
                return None
            rows.append(conditions + [meet.by, pencil.by])
    return rows


def place_point(place, point, i, j):
    """*Epipolar* of steps 4 and 5: its row in a list, or None."""
    first, second = place.ray(i, point), place.ray(j, point)
    base = place.seen(j, minus(place.centres[j], place.centres[i]))
    factor = Small(place.draw())
    on_the_line = [x + factor * y for x, y in zip(second, base)]
    row = place.epipolar(i, first, j, second)
    return [row.by] if place.cut(row, place.epipolar(i, first, j, on_the_line)) else None


def has_all_permutations(features, seed):
    place = Place(seed)
    rows = place_first_steps(place, features)
    if rows is None:
        return False
    pairs, views = {}, {}  # how often
    images = {u: [] for u in range(3)}  # the row of the feature, and those of the image
    for feature in features:
        if feature.point is None or len(feature.point) == 3:
            continue
        seen, unseen = split(feature)
        if len(seen) == 1:
            views[seen[0]] = views.get(seen[0], 0) + 1
        elif not feature.lines:
            pairs[tuple(seen)] = pairs.get(tuple(seen), 0) + 1
        elif feature.lines != (frozenset({0, 1, 2}),):
            (i, j), (u,) = seen, unseen
            point = place.vector()
            ray, plane = place.ray(i, point), place.plane(j, point)
            image = [place.incidence(i, ray, j, plane, u, place.plane(u, point)).by
                     for _ in range(2)]
            row = place_point(place, point, i, j)
            if row is None:
                return False
            rows.append(row)
            images[u].append((row, image))
    count = sum(pairs.values()) + sum(views.values()) + sum(map(len, images.values()))
    assert len(place.known) == 11 - count
    motion = place.known.motion(place.draw)
    if count == 0 or not all(place.general_matrices(*pair, motion) for pair in pairs) \
            or not all(place.general_tensors(view, motion) for view in views):
        return False
    poses = {pair: place.relative_pose(*pair) for pair in pairs}
    # Condition (b), for conditions that do not know everything.
    for chosen in product((False, True), repeat=len(pairs)):
        for numbers in product(*(range(len(images[u]) + 1) for u in range(3))):
            taken = [pair for pair, is_in in zip(pairs, chosen) if is_in]
            size = sum(pairs[pair] for pair in taken) + sum(numbers)
            if not 0 < size < count:
                continue
            known = [row for pair in taken for row in poses[pair]]
            known += [row for u in range(3) for _, image in images[u][:numbers[u]] for row in image]
            if len(place.known.with_all(known)) - len(place.known) <= size:
                return False
    # Condition (c).
    if views or len(pairs) == 3:
        return True
    known = [row for pose in poses.values() for row in pose]
    return any(
        len(Rows().with_all(known + [row for other in rows if other is not own for row in other]
                            + [row for u in range(3) for epipolar, image in images[u]
                               if epipolar is not own for row in image])) == 11
        for own in rows)


def known_in_third_view(features, i, j, u):
    """(pins of known points, known lines, incidences, how many P/P/- for views i and j)"""
    points, lines, incidences, rays = [], 0, 0, {i: 0, j: 0}
    for feature in features:
        in_all = frozenset({0, 1, 2}) in feature.lines
        if feature.point is None:
            lines += 1
        elif len(feature.point) == 3:
            points.append(len(feature.lines))
        elif len(feature.point) == 1:
            incidences += 1
        elif feature.point == {i, j}:
            lines += in_all
            incidences += bool(feature.lines) and not in_all
        elif feature.lines:
            points.append(int(in_all))
        else:
            rays[min(feature.point - {u})] += 1
    return points, lines, incidences, rays


def has_all_third_cameras(features, seed):
    """The tests of Theorem P."""
    shared = [pair for pair in ((0, 1), (0, 2), (1, 2))
              if sum(set(pair) <= (f.point or set()) for f in features) == 5]
    if len(shared) != 1:
        return False
    i, j = shared[0]
    u = 3 - i - j
    points, lines, incidences, rays = known_in_third_view(features, i, j, u)
    epipolar = sum(rays.values())
    one_camera_fits = (incidences or all(rays.values()) or
                       epipolar and (lines or len(points) + sum(points) >= 2))
    if not one_camera_fits or not (2 * len(points) + lines <= 3 or
                                   (len(points), lines) == (2, 0)):
        return False
    place = Place(seed)
    place.known = place.known.with_all(place.relative_pose(i, j))

    def image(point):
        return place.incidence(i, place.ray(i, point), j, place.plane(j, point), u,
                               place.plane(u, point))

    meets = []
    for _ in range(lines):
        point, direction = place.vector(), place.vector()
        normals = [place.plane(v, point, direction) for v in range(3)]
        parallel = place.seen(u, cross(direction, place.vector()))
        if not place.cut(det(normals[i], normals[j], normals[u]),
                         det(normals[i], normals[j], parallel)):
            return False
        meets.append(place.incidence(i, place.ray(i, point), j, normals[j], u, normals[u]))
    known = [place.vector() for _ in points]
    if not all(map(place.keep, meets + [image(point) for point in known for _ in range(2)])):
        return False
    for point, pins in zip(known, points):
        for _ in range(pins):
            direction = place.vector()
            if not general_known_pin(place, point, i, j, u) or not place.keep(
                    det(*(place.plane(v, point, direction) for v in range(3)))):
                return False
    motion = place.known.motion(place.draw)
    turn = [x.along(motion) for x in minus(place.turns[u], place.turns[i])]
    if not dot(turn, turn) % P:  # Lemma P2
        return False
    if not all(place.general_matrices(view, u, motion) for view in (i, j) if rays[view]):
        return False
    seen = [view for view in (i, j) if rays[view]]
    for chosen in product((False, True), repeat=len(seen)):
        taken = [view for view, is_in in zip(seen, chosen) if is_in]
        size = sum(rays[view] for view in taken)
        if size == epipolar + incidences:  # all of the free conditions
            continue
        more = [row for view in taken for row in place.relative_pose(view, u)]
        if size and len(place.known.with_all(more)) - len(place.known) <= size:
            return False
    return True


def general_known_pin(place, point, i, j, u):
    """Lemma P5."""
    normals = [place.plane(u, point) for _ in range(2)]
    units = [[Small(int(a == b)) for b in range(3)] for a in range(3)]
    # The coordinates of the normals, as view i sees them.
    frame = [place.seen(i, unit) for unit in units]
    form = [[dot(axis, normal) for normal in normals] for axis in frame]
    first, *others = [x for row in form for x in row]
    ratios = [[(first.value * x - other.value * y) % P for x, y in zip(other.by, first.by)]
              for other in others]
    if len(place.known.with_all(ratios)) < len(place.known) + 2:
        return False
    motion = place.known.motion(place.draw)
    value = [[x.value for x in row] for row in form]
    moved = [[x.along(motion) for x in row] for row in form]
    minors = [less(times(value[a], moved[b]), times(value[b], moved[a]))
              for a, b in ((0, 1), (0, 2), (1, 2))]
    if not any(len(trimmed(minor)) == 3 for minor in minors):
        return False  # a zero at infinity, perhaps
    return len(common_divisor(common_divisor(minors[0], minors[1]), minors[2])) == 1


def rows_of(path):
    """The rows of a table, by their numbers."""
    with open(path, encoding="utf-8") as lines:
        return {int(row["number"]): row
                for row in csv.DictReader(line for line in lines if not line.startswith("#"))}


def main(plcheck, certs, every=1):
    output = subprocess.run([plcheck, "--json", "--table", f"{certs}/classification.plc"],
                            capture_output=True, text=True, check=True).stdout
    certified = dict(json.loads(output)["certified_groups"])
    on_file = {number: row["group"] for number, row in rows_of(f"{certs}/groups.csv").items()}
    degrees = {number: int(row["degree"])
               for number, row in rows_of(f"{certs}/degrees.csv").items()}
    seen, wrong, found = set(), 0, 0
    for number, signature in enumerate(CLASSES.all()):
        features = [FEATURES[i] for i, n in enumerate(signature) for _ in range(n)]
        key = largest_form(signature, SWAPS + EXCHANGES)
        excess, star = obstruction(features)
        if key in seen or any(excess) or star:
            continue
        seen.add(key)
        if (len(seen) - 1) % every:
            continue
        degree = degrees[number]
        group = None
        if has_all_permutations(features, number):
            group = f"S{degree}"
        elif has_all_third_cameras(features, number):
            group = f"<S{degree // 20} wr S2 wr S10"
        found += group is not None
        if group != certified.get(number) or group not in (None, on_file.get(number)):
            wrong += 1
            print(f"class {number}: {group}, plcheck {certified.get(number)}, "
                  f"on file {on_file.get(number)}")
    print(f"{len(seen)} constraint classes, of {-(-len(seen) // every)} {found} have their group by "
          f"theorem, {wrong} differ")
    return 1 if wrong or not found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3], *map(int, sys.argv[3:])))
