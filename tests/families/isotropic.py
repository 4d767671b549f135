#!/usr/bin/env python3
"""Computes degrees of problems in three views once more, by Groebner bases in isotropic coordinates.

    tests/families/isotropic.py certs/family-degrees.csv

Two kinds of problems: with known verticals and a focal length each, if no three points are on a line; and
with one focal length, or one each, if there are three points on a line and lines without points. Nothing is
shared with plprove and plcheck, and with groebner.py not the equations. There cameras are matrices. Here the
unknowns are angles u, as numbers z = exp(i u), and (x, y) in a plane is x + i y and x - i y: a rotation
multiplies them by z and 1/z. So equations have few terms, and Singular takes seconds where entries of
matrices take too long. Images are random modulo a prime that has a root of -1. Status 1 if some number is not
the degree on file.

*Known verticals.* Camera v turns by z_v, g_v is 1/f_v. An image line (l1, 1, l3) shows a plane whose normal has
the coordinates n = (l1/i + l3 g)/z and n' = (-l1/i + l3 g) z, and 1 in height. Three planes share a
direction if n, n', 1 are dependent. Let O be a point, at the depth m_v/g_v: then the plane is as far from O as
m_v times l.x_v, for the image x_v. Signs of all g and of all angles may change together.

*Three points on a line.* Camera v sees the points of the line at alpha_v a + beta_v b, its direction at
alpha_v q + beta_v = (g+, g-, g3) in isotropic image coordinates. An isotropic vector of space that is orthogonal to
the line is seen at V (g+ (c-g3), -g- (c+g3), c^2-g3^2), the other one at Y (-g+ (c+g3), g- (c-g3), c^2-g3^2)
with V Y (c^2-g3^2) = 1, where c is a length, and f^2 = g+ g-/(c^2-g3^2). All c may change their sign.
"""
import csv
import itertools
import random
import sys

from groebner import P, compare, count_of, cross, inverse, read_problem

FAMILIES = ["upright-focal", "shared-focal", "focal"]
I = next(root for root in (pow(a, (P - 1) // 4, P) for a in range(2, 99)) if root * root % P == P - 1)
VIEWS = range(3)
PAIRS = [(0, 1), (1, 2), (2, 0)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b)) % P


def total(terms):
    return "+".join(terms)


class Upright:
    """Equations of three views with known verticals and a focal length each."""

    ANGLES = ["1", "z2", "z3"]
    INVERSE = ["z2*z3", "z3", "z2"]  # times z2 z3
    DEPTHS = ["1", "m2", "m3"]

    def __init__(self, features, dice):
        self.dice = dice
        self.equations, self.units = [], ["z2", "z3", "g1", "g2", "g3"]
        points = [(self.image(), len(feature) - 1) for feature in features if feature[0] == "P"]
        joins = [self.line(a, b) for (a, _), (b, _) in itertools.combinations(points, 2)]
        pins = [self.line(x, self.image()) for x, count in points for _ in range(count)]
        free = [self.line(self.image(), self.image()) for feature in features if feature[0] != "P"]
        lines = joins + pins + free
        for line in lines:
            normals = [self.normal(line, v) for v in VIEWS]
            self.equations.append(total(
                f"{normals[v][0]}*{normals[w][1]}-{normals[w][0]}*{normals[v][1]}" for v, w in PAIRS))
        for x, count in points:
            if count + len(points) - 1 >= 3:
                self.units.append(self.rays_differ(x))
        self.names = ["z2", "z3", "g1", "g2", "g3"]
        if len(lines) < 5:  # five directions leave linear equations
            self.names += ["m2", "m3"]
            self.units += ["m2", "m3"]
            self.origin = points[0][0]
            for line in free:
                self.add_position(line)
            for (x, _), join in zip(points[1:], joins):
                self.add_point(x, join)

    def image(self):
        return [[self.dice.randrange(1, P), self.dice.randrange(1, P), 1] for _ in VIEWS]

    @staticmethod
    def line(a, b):
        lines = [cross(x, y) for x, y in zip(a, b)]
        return [[value * inverse(line[1]) % P for value in line] for line in lines]

    def normal(self, line, v):
        slope, c = line[v][0] * inverse(I) % P, line[v][2]
        return f"{self.INVERSE[v]}*({slope}+{c}*g{v + 1})", f"{self.ANGLES[v]}*({P - slope}+{c}*g{v + 1})"

    @staticmethod
    def rays_differ(x):
        first, second = (f"(1+{x[v][0] * I % P}*g{v + 1})" for v in (0, 1))
        return f"({first}*{x[1][1]}*g2-z2*{second}*{x[0][1]}*g1)"

    def add_position(self, line):
        """The sum of the distances from O, times the minors of the normals."""
        for k in (0, 1):
            n = [self.normal(line, v)[k] for v in VIEWS]
            self.equations.append(total(
                f"({n[v - 2]}-{n[v - 1]})*{dot(line[v], self.origin[v])}*{self.DEPTHS[v]}" for v in VIEWS))

    def add_point(self, x, join):
        """On the line from O, whose direction two normals determine, it is in three vertical planes."""
        for s, t in PAIRS:
            (a, b), (c, d) = self.normal(join, s), self.normal(join, t)
            place, distance = [], []
            for v in VIEWS:
                slope, g = inverse(I), f"{P - x[v][0]}*g{v + 1}"
                place.append(f"({self.INVERSE[v]}*({slope}+{g})*({b}-{d})+"
                             f"{self.ANGLES[v]}*({P - slope}+{g})*({c}-{a}))")
                distance.append(f"{(self.origin[v][0] - x[v][0]) % P}*{self.DEPTHS[v]}")
            self.equations += [f"{place[v]}*{distance[w]}-{place[w]}*{distance[v]}" for v, w in PAIRS]


class ThreePoints:
    """Equations of three views that see three points on a line."""

    def __init__(self, features, dice, one_focal_length):
        self.dice = dice
        self.alpha, self.beta = ([self.vector() for _ in VIEWS] for _ in range(2))
        self.seen = [[f"({a}*q+{b})" for a, b in zip(*pair)] for pair in zip(self.alpha, self.beta)]
        self.v, self.y = ["1", "V2", "V3"], ["Y1", "Y2", "Y3"]
        self.w = [f"(c{v + 1}^2-{self.seen[v][2]}^2)" for v in VIEWS]
        self.names = ["V2", "V3", "Y1", "Y2", "Y3", "c1", "c2", "c3", "q"]
        self.units = [f"c{v + 1}" for v in VIEWS] + [form for forms in self.seen for form in forms[:2]]
        self.equations = [f"{v}*{y}*{w}-1" for v, y, w in zip(self.v, self.y, self.w)]
        squares = [f"{plus}*{minus}" for plus, minus, _ in self.seen]  # f^2, times w
        if one_focal_length:
            self.equations += [f"{squares[0]}*{self.w[v]}-{squares[v]}*{self.w[0]}" for v in (1, 2)]
        for feature in features:
            if feature[0] != "P":
                self.add_line([self.vector() for _ in VIEWS])

    def vector(self):
        return [self.dice.randrange(1, P) for _ in range(3)]

    def isotropic(self, line, v):
        """What an image line says of the two isotropic vectors."""
        plus, minus, third = self.seen[v]
        l, c = line[v], f"c{v + 1}"
        return (f"{self.v[v]}*({l[0]}*{plus}*({c}-{third})-{l[1]}*{minus}*({c}+{third})+{l[2]}*{self.w[v]})",
                f"{self.y[v]}*({l[1]}*{minus}*({c}-{third})-{l[0]}*{plus}*({c}+{third})+{l[2]}*{self.w[v]})")

    def add_line(self, line):
        minors = cross([dot(line[v], self.alpha[v]) for v in VIEWS],
                       [dot(line[v], self.beta[v]) for v in VIEWS])
        for k in (0, 1):
            self.equations.append(total(f"{minors[v]}*{self.isotropic(line, v)[k]}" for v in VIEWS))


def system(notation):
    """The equations of a problem; None if they are not for it."""
    kind, views, features = read_problem(notation)
    points = [feature for feature in features if feature[0] == "P"]
    dice = random.Random(notation)
    if views != 3:
        return None
    if kind == "upright-focal" and "L" not in notation:
        return Upright(features, dice)
    if kind in ("shared-focal", "focal") and points == 3 * ["PL"]:
        return ThreePoints(features, dice, kind == "shared-focal")
    return None


def degree(notation):
    """How many solutions there are; what Singular says instead, if it does not find finitely many."""
    equations = system(notation)
    found = count_of(f"ring r = {P}, ({','.join(['t'] + equations.names)}), dp;\n"
                     f"ideal G = {','.join(equations.equations)}, t*{'*'.join(equations.units)}-1;\n"
                     "G = slimgb(G);\n")
    is_even = isinstance(found, int) and found % 2 == 0
    return found // 2 if is_even else found  # signs may change


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        known = {row["problem"]: int(row["degree"])
                 for row in csv.DictReader(line for line in file if not line.startswith("#"))
                 if row["bound"] == "exact" and row["family"] in FAMILIES and system(row["problem"])}
    return compare(known, degree, "in isotropic coordinates")


if __name__ == "__main__":
    sys.exit(main())
