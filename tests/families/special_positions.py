#!/usr/bin/python3
"""A law of degrees in three views (proofs/results/special_positions.md): where images of one feature are a special
position of images of others, a problem with these in its place has no fewer solutions.

    special_positions.py CERTS [KIND...]         whether the degrees on file obey the law; and whether each class of
                                                 `shared-focal` is on file, or has more than 300 solutions by the law
    special_positions.py --paths EVERY PROGRAM   whether each EVERY-th of above_300.txt has, by this degrees_in_part
    special_positions.py --positions             prints the positions

A position counts if the equations of these features, at images of the one, have independent differentials: exactly,
modulo a prime. Nothing is shared with plprove or plcheck. Status 1 if a degree contradicts the law, or one is missing.
"""
import functools
import itertools
import pathlib
import random
import subprocess
import sys

import shared_points
import three_views
import three_views_degrees
from ranks import Q, rank

TRIES = 4  # for each letter of a feature, to draw the lines and points that a position leaves open
KINDS = ["upright", "upright-shared-focal", "shared-focal", "calibrated"]
ABOVE = pathlib.Path(__file__).with_name("above_300.txt")


def dot(a, b):
    return sum(x * y for x, y in zip(a, b)) % Q


def cross(a, b):
    return [(a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2]) % Q for i in range(3)]


def determinant(rows):
    if len(rows) == 1:
        return rows[0][0] % Q
    return sum((-1) ** i * row[0] * determinant([other[1:] for other in rows[:i] + rows[i + 1:]])
               for i, row in enumerate(rows) if row[0]) % Q


class Scene:
    """One feature in space, and three upright cameras, which cameras of all kinds may be."""

    def __init__(self, feature, chance):
        self.chance = chance
        self.cameras = [self.upright_camera() for _ in range(3)]
        views, point = feature.split("/"), self.vector(4)
        self.points = {view: self.image(view, point) for view in range(3) if "P" in views[view]}
        self.pins = []
        for pin in sorted({letter for seen in views for letter in seen if letter.islower()}):
            other = self.vector(4)
            self.pins.append({view: cross(self.image(view, point), self.image(view, other))
                              for view in range(3) if pin in views[view]})

    def vector(self, size):
        return [self.chance.randrange(Q) for _ in range(size)]

    def upright_camera(self):
        m, t = self.chance.randrange(Q), self.vector(3)
        scale = pow(1 + m * m, -1, Q)
        cosine, sine = (1 - m * m) * scale % Q, 2 * m * scale % Q
        return [[cosine, 0, sine, t[0]], [0, 1, 0, t[1]], [-sine, 0, cosine, t[2]]]

    def image(self, view, point):
        return [dot(row, point) for row in self.cameras[view]]

    def through(self, point):
        """A line through an image point, or a point on an image line."""
        return cross(point, self.vector(3))

    def line(self, view):
        """A line through the image of the feature's point, as the view shows it."""
        if view in self.points:
            return self.through(self.points[view])
        return self.chance.choice([pin[view] for pin in self.pins if view in pin])

    def pins_in_all(self):
        return [pin for pin in self.pins if len(pin) == 3]

    def differential(self, planes):
        """By the entries of the cameras, of the determinant of four planes that meet in a point: each is a view and a
        line of its image."""
        rows = [[sum(line[i] * self.cameras[view][i][k] for i in range(3)) % Q for k in range(4)]
                for view, line in planes]
        result = [[0] * 12 for _ in range(3)]
        for n, (view, line) in enumerate(planes):
            others = rows[:n] + rows[n + 1:]
            cofactors = [(-1) ** (n + k) * determinant([row[:k] + row[k + 1:] for row in others]) for k in range(4)]
            for i, k in itertools.product(range(3), range(4)):
                result[view][4 * i + k] += line[i] * cofactors[k]
        return [x % Q for row in result for x in row]

    def ray(self, view, point):
        return [(view, self.through(point)), (view, self.through(point))]

    def epipolar(self, views):
        return self.differential([plane for view in views for plane in self.ray(view, self.points[view])])

    def on_line(self, view, point, lines):
        """The ray of an image point meets the line whose images in two views are these."""
        return self.differential(self.ray(view, point) + list(lines.items()))

    def of_pin(self, pin):
        """A line that all views show: the ray of a point of its first image meets it."""
        return self.on_line(0, self.through(pin[0]), {1: pin[1], 2: pin[2]})

    def shows(self, part):
        views = part.split("/")
        seeing = {view for view in range(3) if "P" in views[view]}
        if len(seeing) == 1:
            return seeing <= set(self.points) or bool(self.pins_in_all())
        return seeing <= set(self.points) and pins_seen_by_all(views) <= len(self.pins_in_all())

    def equations(self, part):
        """The differentials of the equations of a feature that the scene shows, at random such images of it."""
        views = part.split("/")
        seeing = [view for view in range(3) if "P" in views[view]]
        pins = self.chance.sample(self.pins_in_all(), pins_seen_by_all(views)) if len(seeing) != 1 else []
        if not seeing:
            return [self.of_pin(pins[0]), self.of_pin(pins[0])]
        if len(seeing) == 1:
            return [self.point_on_line(seeing[0])]
        found = [self.epipolar((seeing[0], other)) for other in seeing[1:]] + [self.of_pin(pin) for pin in pins]
        if "-" not in views:
            view, other = seeing[:2]
            third = 3 - view - other
            line = pins[0][third] if pins and third not in seeing else self.line(third)
            found.append(self.on_line(view, self.points[view], {other: self.through(self.points[other]), third: line}))
        return found

    def point_on_line(self, view):
        """The ray of an image point of this view meets a line that the others show."""
        others = [other for other in range(3) if other != view]
        pins = self.pins_in_all() + [None] * (view in self.points)
        pin = self.chance.choice(pins)
        if pin is None:
            return self.on_line(view, self.points[view], {other: self.line(other) for other in others})
        return self.on_line(view, self.through(pin[view]), {other: pin[other] for other in others})


def pins_seen_by_all(views):
    return len(set.intersection(*({letter for letter in seen if letter.islower()} for seen in views)))


def is_special(feature, parts, chance):
    """Whether images of the feature are a special position of images of the parts."""
    for _ in range(TRIES * (1 + len(feature.strip("P-/")))):
        scene = Scene(feature, chance)
        if not all(map(scene.shows, parts)):
            return False
        if rank([row for part in parts for row in scene.equations(part)]) == three_views.weight(feature):
            return True
    return False


@functools.cache
def positions():
    """For each feature the two or three features whose special position it is. Of features that put the same
    conditions on cameras only one appears."""
    chance, weight = random.Random(1), three_views.weight
    others = {other for _, other in three_views_degrees.PAIRS}
    # A point with eight or nine lines has equations that depend on each other; so no minimal problem has it.
    features = [feature for feature in three_views.features_of(12)
                if feature not in others and is_special(feature, [feature], chance)]
    found = {}
    for feature in features:
        numbers = (2, 3) if weight(feature) < 5 else (2,)
        choices = [parts for number in numbers for parts in itertools.combinations_with_replacement(features, number)]
        found[feature] = [parts for parts in choices
                          if sum(map(weight, parts)) == weight(feature) and is_special(feature, parts, chance)]
    return found


class Order(shared_points.Classes):
    """The constraint classes of a kind, and which are special positions of which."""

    def more_general(self, key):
        """The keys of the classes with others in the place of one feature."""
        for place, count in enumerate(key):
            for parts in positions().get(self.features[place], ()) if count else ():
                signature = list(key)
                signature[place] -= 1
                for part in parts:
                    signature[self.features.index(part)] += 1
                yield three_views_degrees.merged(signature, self.pairs, self.permutations)

    def all_more_general(self, keys):
        """These, and all that they are special positions of."""
        found = set(keys)
        left = list(found)
        while left:
            for key in self.more_general(left.pop()):
                if key not in found:
                    found.add(key)
                    left.append(key)
        return found


def contradictions(certs, kind):
    """Prints how many pairs of classes the law compares, and those that contradict it."""
    order = Order(kind)
    known = shared_points.known_degrees(certs, kind, order)
    pairs = [(key, general) for key in known if known[key] for general in set(order.more_general(key))
             if general in known or kind != "shared-focal"]
    wrong = [(key, general) for key, general in pairs if known.get(general, 0) < known[key]]
    for key, general in wrong[:10]:
        print(f"{known[key]} for {three_views.notation(kind, order.features, key)}, but {known.get(general, 0)} for "
              f"{three_views.notation(kind, order.features, general)}")
    print(f"{kind}: {len(pairs)} pairs of classes, {len(wrong)} contradict the law")
    return len(wrong) + (not pairs)


def above_300():
    return [line.strip() for line in ABOVE.read_text().splitlines() if not line.startswith("#")]


def missing(certs, kind):
    """How many classes are not on file, nor have more than 300 solutions by the law; or are on file with
    fewer."""
    order = Order(kind)
    known = shared_points.known_degrees(certs, kind, order)
    above = order.all_more_general([order.key(shared_points.expanded(problem)) for problem in above_300()] +
                                   [key for key in known if known[key] > 300])
    classes = {order.key(shared_points.expanded(problem)): count
               for problem, count in three_views_degrees.constraint_classes(kind)}
    lost = [key for key in classes if key not in known and key not in above]
    wrong = [key for key in known if key in above and known[key] <= 300]
    print(f"{kind}: {len(above.difference(known))} of {len(classes)} classes are not on file, and have more than 300 "
          f"solutions by the law; {len(lost)} are missing, {len(wrong)} contradict it")
    return len(lost) + len(wrong)


def fewer_by_paths(every, program):
    """How many of the problems with more than 300 solutions have fewer, as this program counts."""
    run = subprocess.run([program, "300"], input="".join(f"{problem},0\n" for problem in above_300()[::every]),
                         capture_output=True, text=True, check=True)
    found = [line.split(",")[2] for line in run.stdout.splitlines()]
    print(f"{found.count('-')} of {len(found)} problems have more than 300 solutions by paths")
    return len(found) - found.count("-") + (not found)


def main():
    if sys.argv[1] == "--positions":
        for feature, found in positions().items():
            print(feature, *sorted(" + ".join(parts) for parts in found), sep="\n    ")
        return
    if sys.argv[1] == "--paths":
        sys.exit(fewer_by_paths(int(sys.argv[2]), sys.argv[3]) > 0)
    certs, kinds = pathlib.Path(sys.argv[1]), sys.argv[2:] or KINDS
    wrong = [contradictions(certs, kind) + (kind == "shared-focal" and missing(certs, kind)) for kind in kinds]
    sys.exit(sum(wrong) > 0)


if __name__ == "__main__":
    main()
