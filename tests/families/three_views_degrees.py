#!/usr/bin/python3
"""Degrees of problems in three views that may each miss points and lines, of cameras that are known in part.

    three_views_degrees.py KIND [NOTATION...]        a line for each constraint class, or of these problems
    three_views_degrees.py --list KIND               the constraint classes alone, for degrees_in_part
    three_views_degrees.py --check TABLE EVERY       whether each EVERY-th line of `upright` comes out again
    three_views_degrees.py --paths TABLE EVERY PROGRAM      the same of all lines of at most 400, by this degrees_in_part

But for the last, nothing is shared with plprove or plcheck. Images are random modulo a prime, and Singular counts the
cameras that explain them, up to motions of space. Status 1 if a line of the table is wrong.

Problems whose features put the same conditions on cameras are in one *constraint class*: a feature is as good as
another where they differ in which of two views sees the line of a point besides the point, or in a second line
(certs/FORMAT.md, sections 1 and 9); the order of the views does not matter. A line has a problem of the class, the
number of its label classes, the degree, and how it was counted. The degree is 0 if there is no solution, - if there
are infinitely many: such a class is not minimal.
"""
import collections
import concurrent.futures
import itertools
import os
import random
import subprocess
import sys

import groebner
import three_views

LONGEST = 600  # seconds
MOST_BY_PATHS = 400
SOURCE = "by Groebner bases for its constraint class"
PAIRS = [("a/P/Pa", "a/Pa/P"), ("P/a/Pa", "Pa/a/P"), ("P/Pa/a", "Pa/P/a"),
         ("P/a/a", "Pab/b/a"), ("a/P/a", "b/Pab/a"), ("a/a/P", "b/a/Pab")]


def pairs_of(features):
    """The places of those that are as good as others, with the places of these."""
    return [(features.index(one), features.index(other)) for one, other in PAIRS if other in features]


def merged(signature, pairs, permutations):
    """The largest signature of the constraint class."""
    orbit = []
    for places in permutations:
        counts = list(three_views.moved(signature, places))
        for one, other in pairs:
            counts[one] += counts[other]
            counts[other] = 0
        orbit.append(tuple(counts))
    return max(orbit)


def constraint_classes(kind):
    """For each constraint class its problem with the largest signature, and how many label classes it has."""
    parameters = three_views.PARAMETERS[kind]
    features = three_views.features_of(parameters)
    weights, permutations = list(map(three_views.weight, features)), three_views.permutations_of(features)
    pairs, found = pairs_of(features), collections.Counter()
    for signature in three_views.signatures(weights, parameters):
        if all(signature >= three_views.moved(signature, places) for places in permutations):
            found[merged(signature, pairs, permutations)] += 1
    return [(three_views.notation(kind, features, signature), count) for signature, count in found.items()]


def residue(number):
    """As Singular wants it: products of what it takes for integers have 32 bits."""
    return f"poly({number})"


def dot(a, b):
    return "+".join(f"({x})*({y})" for x, y in zip(a, b))


def cross(a, b):
    return [f"({a[i - 2]})*({b[i - 1]})-({a[i - 1]})*({b[i - 2]})" for i in range(3)]


def matrix_of_cross(a):
    """Its rows times b are the cross product of a and b."""
    return [["0", f"-({a[2]})", a[1]], [a[2], "0", f"-({a[0]})"], [f"-({a[1]})", a[0], "0"]]


def difference(a, b):
    return [f"{x}-{y}" for x, y in zip(a, b)]


class Equations:
    """What Singular has to solve. Camera v shows M (X - centre) of a point X, with M = K R inverse(K1) for the
    matrix K1 of view 1, whose camera is [I | 0]. e is f^2, s the sine of the angle divided by f, and r the ratio
    of two focal lengths."""

    def __init__(self, problem):
        kind, _, self.features = problem.partition(": ")
        self.dice = random.Random(problem)
        focal, own = kind != "upright", kind == "upright-focal"
        self.e = "e" if focal else "1"
        self.names, self.units = ["e"] * focal, ["e"] * focal
        self.ideal = []
        self.turns, self.centres = [("1", "0", "1")], [["0", "0", "0"]]
        for v in (2, 3):
            self.turns.append((f"c{v}", f"s{v}", f"r{v}" if own else "1"))
            self.centres.append([f"x{v}", f"y{v}", f"z{v}"])
            self.names += [*self.turns[-1][:2 + own], *self.centres[-1]]
            self.units += [f"r{v}"] * own
            self.ideal.append(f"c{v}^2+{self.e}*s{v}^2-1")
        # Space has no scale.
        self.ideal.append("+".join(f"{self.number()}*{x}" for x in self.centres[1] + self.centres[2]) + "-1")

    def number(self):
        return self.dice.randrange(1, groebner.P)

    def vector(self):
        return [self.number() for _ in range(3)]

    def ray(self, view, image):
        """The direction of an image point: inverse(M) times it, up to a factor."""
        (c, s, r), (x, y, z) = self.turns[view], map(residue, image)
        return [f"{c}*{x}-{self.e}*{s}*{r}*{z}", y, f"{s}*{x}+{r}*{c}*{z}"]

    def plane(self, view, image):
        """The normal of the plane of an image line: the transpose of M times it."""
        (c, s, r), (x, y, z) = self.turns[view], map(residue, image)
        return [f"{r}*{c}*{x}-{s}*{z}", f"{r}*{y}", f"{r}*{self.e}*{s}*{x}+{c}*{z}"]

    def add_free_line(self):
        """Three planes have a line in common."""
        planes = [self.plane(view, self.vector()) for view in range(3)]
        rows = [row + [dot(row, centre)] for row, centre in zip(planes, self.centres)]
        for columns in itertools.combinations(range(4), 3):
            a, b, c = ([row[i] for i in columns] for row in rows)
            self.ideal.append(dot(a, cross(b, c)))

    def seen_along(self, ray, first, view, form):
        """What a form is of ray + w (centre - centre'): the constant, and the coefficient of w."""
        return dot(form, ray), dot(form, difference(self.centres[first], self.centres[view]))

    def add_point(self, views):
        points = {view: self.vector() for view, seen in enumerate(views) if "P" in seen}
        lines = {(view, pin): groebner.cross(points[view], self.vector()) if view in points else self.vector()
                 for view, seen in enumerate(views) for pin in seen if pin.islower()}
        rays = {view: self.ray(view, image) for view, image in points.items()}
        first, *others = points
        planes = {place: self.plane(place[0], line) for place, line in lines.items()}
        # The point is centre + ray / w, with the same w for all; if it is no centre, not all coefficients of w vanish.
        seen = [self.seen_along(rays[first], first, view, form)
                for view in others for form in matrix_of_cross(rays[view])]
        seen += [self.seen_along(rays[first], first, view, planes[view, pin])
                 for view, pin in planes if view not in points]
        self.ideal += [f"({a})*({d})-({b})*({c})" for (a, b), (c, d) in itertools.combinations(seen, 2)]
        self.units.append("+".join(f"{self.number()}*({b})" for _, b in seen))
        # It is not at infinity: there, planes through it need no line in common for the last equation.
        self.units.append("+".join(f"{self.number()}*({a})" for a, _ in seen))
        for pin in {pin for _, pin in lines}:
            if all((view, pin) in planes for view in range(3)):
                self.ideal.append(dot(planes[0, pin], cross(planes[1, pin], planes[2, pin])))

    def program(self):
        for term in self.features.split(" + "):
            count, _, feature = term.rpartition("*")
            for _ in range(int(count or 1)):
                if "P" in feature:
                    self.add_point(feature.split("/"))
                else:
                    self.add_free_line()
        text = f"ring r = {groebner.P}, ({','.join(['u'] + self.names)}), dp; option(redSB);\n"
        text += f"ideal G = {','.join(self.ideal)}; G = u, std(G); attrib(G, \"isSB\", 1); poly g = 1;\n"
        for unit in self.units:
            text += f"g = reduce(g*({unit}), G);\n"
        return text + 'G[1] = u*g-1; G = std(G); print("COUNT "+string(dim(G))+" "+string(vdim(G)));\nquit;\n'


def degree(problem):
    """The number of solutions as text; `-` if there are infinitely many, `?` if Singular takes minutes."""
    try:
        run = subprocess.run(["Singular", "-q"], input=Equations(problem).program(), capture_output=True,
                             text=True, check=True, timeout=LONGEST)
    except subprocess.TimeoutExpired:
        return "?"
    dimension, _, count = run.stdout.rpartition("COUNT ")[2].strip().partition(" ")
    return {"-1": "0", "0": count}.get(dimension, "-")


def degrees(problems):
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as threads:
        yield from zip(problems, threads.map(degree, problems))


def by_paths(problems, program):
    run = subprocess.run([program, "1000000"], input="".join(f"{problem},0\n" for problem in problems),
                         capture_output=True, text=True, check=True)
    for line in run.stdout.splitlines():
        problem, _, found, _ = line.split(",")
        yield problem, found


def check(table, every, program=None):
    with open(table, encoding="utf-8") as file:
        rows = [line.strip().split(",") for line in file if not line.startswith("#")][1:]
    known = {problem: number for problem, _, number, _ in rows
             if (int(number) <= MOST_BY_PATHS if program else problem.startswith("upright:"))}
    known = dict(list(known.items())[::every])
    again = by_paths(known, program) if program else degrees(list(known))
    wrong = {problem: found for problem, found in again if found != known[problem]}
    for problem, found in wrong.items():
        print(f"{problem}: {found}, on file {known[problem]}")
    print(f"{len(known)} degrees by {'paths' if program else 'Groebner bases'}, "
          f"{len(wrong)} of them differ from those on file")
    sys.exit(bool(wrong) or not known)


def main():
    if sys.argv[1] == "--check":
        check(sys.argv[2], int(sys.argv[3]))
    if sys.argv[1] == "--paths":
        check(sys.argv[2], int(sys.argv[3]), sys.argv[4])
    if sys.argv[1] == "--list":
        print("\n".join(f"{problem},{count}" for problem, count in constraint_classes(sys.argv[2])))
        return
    counts = dict(constraint_classes(sys.argv[1]))
    for problem, found in degrees(sys.argv[2:] or list(counts)):
        print(f"{problem},{counts[problem]},{found},{SOURCE}", flush=True)


if __name__ == "__main__":
    main()
