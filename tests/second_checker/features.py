"""Sections 1 to 4: the 27 features, signatures, label classes, obstructions, and pools."""

from collections import namedtuple
from itertools import permutations

from algebra import apply, cross, quaternion_matrix
from general import Problem, jacobian, parse
from lines import Fault, require

# `point` is the set of views that see the point, None for a free line; `lines` has one such set for
# each pin, or for the free line.
Feature = namedtuple("Feature", "point lines")
LETTERS = "abcdefghijklmnopqrstuvwxyz"
TABLE = ("Pabcdefg/Pabcdefg/Pabcdefg Pabcdef/Pabcdef/Pabcdef Pabcde/Pabcde/Pabcde "
         "Pabcd/Pabcd/Pabcd Pabc/Pabc/Pabc Pab/Pab/Pab Pa/Pa/Pa P/P/P a/Pa/Pa Pa/a/Pa Pa/Pa/a a/a/a "
         "a/P/Pa a/Pa/P P/a/Pa Pa/a/P P/Pa/a Pa/P/a -/P/P P/-/P P/P/- P/a/a a/P/a a/a/P Pab/b/a "
         "b/Pab/a b/a/Pab").split()


def parse_feature(name):
    """(the feature, its number of views) of a FEATURE of section 1."""
    views, point, letters = parse(name)
    if views > 3 or "".join(letters) != LETTERS[:len(letters)]:
        raise Fault(f"{name}: the names of pins, or the number of views")
    return Feature(point, tuple(letters.values())), views


def spell(feature, views):
    symbols = []
    for view in range(views):
        seen = "".join(x for x, line in zip(LETTERS, feature.lines) if view in line)
        symbols.append("P" + seen if view in (feature.point or ()) else seen or "-")
    hidden = "".join(x for x, line in zip(LETTERS, feature.lines) if not line)
    if feature.point is not None and not feature.point and len(feature.lines) < 2:
        hidden = "P" + hidden
    return "/".join(symbols) + (f"({hidden})" if hidden else "")


def unnamed(feature):
    return feature.point, sorted(map(sorted, feature.lines))


FEATURES = [parse_feature(name)[0] for name in TABLE]


def index_of(feature):
    """The index in the table up to the names of pins, or None."""
    return next((i for i, f in enumerate(FEATURES) if unnamed(f) == unnamed(feature)), None)


def weight(feature):
    """Degrees of freedom in the images less those in space."""
    points = feature.point or ()
    images = 2 * len(points) + sum(1 if v in points else 2 for line in feature.lines for v in line)
    return images - (4 if feature.point is None else 3 + 2 * len(feature.lines))


def relabeled(feature, order):
    point, *lines = (None if views is None else frozenset(order[v] for v in views)
                     for views in (feature.point, *feature.lines))
    return Feature(point, tuple(lines))


WEIGHTS = [weight(f) for f in FEATURES]
# For each permutation of the views, where each index comes from.
RELABELINGS = [[index_of(relabeled(f, order)) for f in FEATURES] for order in permutations(range(3))]


def representative(signature):
    return max(tuple(signature[i] for i in order) for order in RELABELINGS)


def balanced_signatures(prefix=(), left=11):
    """In decreasing lexicographic order."""
    if len(prefix) == 27:
        if left == 0:
            yield prefix
        return
    step = WEIGHTS[len(prefix)]
    for count in range(left // step, -1, -1):
        yield from balanced_signatures(prefix + (count,), left - count * step)


class Classes:
    """The label classes in the order of their numbers, enumerated when they are needed."""

    def __init__(self):
        self.found, self.signatures = [], 0

    def all(self):
        if not self.found:
            for s in balanced_signatures():
                self.signatures += 1
                if representative(s) == s:
                    self.found.append(s)
            self.numbers = {s: number for number, s in enumerate(self.found)}
        return self.found

    def number(self, signature):
        self.all()
        return self.numbers[representative(signature)]


CLASSES = Classes()
PAIRS = ((0, 1), (0, 2), (1, 2))


def obstruction(features):
    """(excess of the pairs 12, 13, 23; S) of features of the table."""
    excess = [max(0, sum({i, j} <= (f.point or set()) for f in features) - 5) for i, j in PAIRS]
    for star in features:
        pins = len(star.lines)
        if star.point == {0, 1, 2} and pins >= 3:
            others = list(features)
            others.remove(star)
            blind = any(all(v not in views for f in others for views in (f.point or (), *f.lines))
                        for v in range(3))
            if pins == 7 or blind or pins == 6 and any(f.point is None for f in others):
                return excess, 1
    return excess, 0


class Pool:
    """The integers of section 2. `named` turns a FEATURE into a Feature and its number of views."""

    def __init__(self, reader, named):
        self.cameras, self.features, self.names, self.meets = [], [], [], None
        for view in (2, 3):
            if view == 2 or reader.next_is("camera"):
                quaternion, shift = reader.line(f"camera {view} quaternion", 4, "translation", 3)
                self.cameras.append(quaternion + shift)
        while reader.next_is("feature") or not self.features:
            reader.take("feature")
            self.names.append(reader.word())
            feature, views = named(self.names[-1])
            point, *pins = reader.line("point", 3, *("pin", 3) * len(feature.lines))
            if views != len(self.cameras) + 1 or len(self.features) == 1000:
                raise Fault("the views, or the number of the features of a pool")
            self.features.append((feature, point, pins))

    def require(self):
        if self.meets is None:
            self.meets = self.cameras[0][4] != 0 and all(any(c[:4]) for c in self.cameras) and \
                all(self.feature_meets(*feature) for feature in self.features)
        require(self.meets, "the requirements of section 2")

    def feature_meets(self, feature, point, pins):
        for view, numbers in enumerate([[1] + [0] * 6] + self.cameras):
            rotation = quaternion_matrix(*numbers[:4])
            image = [a + b for a, b in zip(apply(rotation, point), numbers[4:])]
            if view in (feature.point or ()) and image[2] == 0 or any(
                    pin[2] == 0 or view in line and not any(cross(image, apply(rotation, pin)))
                    for line, pin in zip(feature.lines, pins)):
                return False
        return True

    def rows(self, number):
        """Section 3: (rows of a feature: own columns, camera columns; how many are own)."""
        feature, point, pins = self.features[number]
        problem = Problem([(feature.point, dict(zip(LETTERS, feature.lines)))],
                          len(self.cameras) + 1)
        rows, width = jacobian(problem, self.cameras, sum(pins, point))
        return rows, width - (11 if len(self.cameras) == 2 else 5)

    def jacobian(self):
        """(J of all features, the number of own columns)."""
        parts = [self.rows(number) for number in range(len(self.features))]
        own_in_all, before, matrix = sum(own for _, own in parts), 0, []
        for rows, own in parts:
            matrix += [[0] * before + row[:own] + [0] * (own_in_all - before - own) + row[own:]
                       for row in rows]
            before += own
        return matrix, own_in_all
