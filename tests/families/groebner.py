#!/usr/bin/env python3
"""Computes degrees of problems with complete visibility a second time, by Groebner bases.

    tests/families/groebner.py certs/family-degrees.csv [quick]

Nothing is shared with plprove or plcheck: no numbers but the degrees in the file, no monodromy and no
theorem. Images are random modulo a prime, and Singular counts the cameras that explain them, up to
motions of space. These are all problems for projective cameras, and those of few solutions for others.
Most take less than a second; `quick` leaves out what takes seconds to minutes. Status 1 if some number is
not the degree on file.

*Projective cameras.* Camera 1 is [I | 0]. So view 1 shows where a point is, up to a depth; three depths are 0 and one is 1, by a
motion. The equations l . (M x + depth t) = 0 of another view are linear in M. Without M they read
N t = 0, with entries of N linear in the depths: the minors of N of size 3 vanish. At some scenes those of
each image do: cameras of rank 1 or 2 see them. So the minors of a further image may not all vanish,
nor det M for any camera. M is computed from t, and t from two rows of N.

Six lines in nine views take too long that way. They are determined by their products, G_ij. A view is
a condition on 16 invariants of them, which are multilinear: 15 products of three G_ij, and the
determinant of the lines' coordinates, with -det G as its square. So nine views are nine linear equations.

*Known verticals, one focal length, or calibrated cameras.* Here M is a polynomial in f^2 and in what a
rotation is made of. Depths and t are unknowns, too. Sine and cosine, or a quaternion with 1 as its first
number, are not what plprove has as unknowns.
"""
import concurrent.futures
import csv
import itertools
import os
import random
import subprocess
import sys

# So large that random numbers do not happen to be special, but few enough digits for Singular.
P = 2**29 - 3
MANY_FREE_LINES = 5
# Solutions, of cameras that are not projective.
MOST_IN_PART, FEW_IN_PART = 30, 6
IN_PART = ["plmp", "upright", "upright-shared-focal", "upright-focal", "shared-focal"]
SIX_LINES = (9, ["a"] * 6)


def read_problem(notation):
    """The cameras, how many views, and what each of them sees of each feature."""
    features = []
    kind, _, rest = notation.rpartition(": ")
    for term in rest.split(" + "):
        count, star, feature = term.rpartition("*")
        views = feature.split("/")
        if len(set(views)) > 1:
            sys.exit(f"{notation}: not all views see all")
        features += int(count or 1) * views[:1]
    return kind, len(views), features


def inverse(a):
    return pow(a, P - 2, P)


def cross(a, b):
    return [(a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2]) % P for i in range(3)]


def reduced(rows, columns):
    """The rows by Gaussian elimination, with the identity in the first columns."""
    rows = [row[:] for row in rows]
    for c in range(columns):
        pivot = next(i for i in range(c, len(rows)) if rows[i][c])
        rows[c], rows[pivot] = rows[pivot], rows[c]
        scale = inverse(rows[c][c])
        rows[c] = [a * scale % P for a in rows[c]]
        for i, row in enumerate(rows):
            if i != c and row[c]:
                rows[i] = [(a - row[c] * b) % P for a, b in zip(row, rows[c])]
    return rows


def determinant(rows):
    rows, product = [row[:] for row in rows], 1
    while rows:
        pivot = next((i for i, row in enumerate(rows) if row[0]), None)
        if pivot is None:
            return 0
        first = rows.pop(pivot)
        product = product * first[0] * (-1) ** pivot % P
        factor = inverse(first[0])
        rows = [[(a - row[0] * factor * b) % P for a, b in zip(row[1:], first[1:])] for row in rows]
    return product


class Problem:
    """Points, with the first two points of the line that carries them, and lines with a point or none."""

    def __init__(self, features, dice):
        self.dice = dice
        self.carriers, self.lines = [], []
        on_line = {}
        for feature in features:
            if feature[0] != "P":
                self.lines.append(None)
                continue
            point, carrier = len(self.carriers), None
            for letter in feature[1:]:
                if letter.islower():
                    self.lines.append(point)
                    continue
                points = on_line.setdefault(letter, [])
                if len(points) >= 2:
                    carrier = points[:2]
                points.append(point)
            self.carriers.append(carrier)

    def vector(self, size=3):
        return [self.dice.randrange(1, P) for _ in range(size)]

    def image(self):
        """Points, factors that make them from those of their carrier, and two points on each line."""
        points, factors = [], []
        for carrier in self.carriers:
            f, g = self.vector(2)
            a, b = (points[i] for i in carrier) if carrier else (self.vector(), self.vector())
            points.append([(f * s + g * t) % P for s, t in zip(a, b)])
            factors.append((f, g))
        lines = [(self.vector() if point is None else points[point], self.vector()) for point in self.lines]
        return points, factors, lines

    def places(self):
        """What view 1 shows: vectors, and their depths as sums of own depths, a dictionary; and the
        places that each line has beside its point."""
        points, factors, lines = self.image()
        places, count = [], itertools.count()
        for x, pair, carrier in zip(points, factors, self.carriers):
            depth = {} if carrier else {next(count): 1}
            for factor, other in zip(pair, carrier or ()):
                for own, a in places[other][1].items():
                    depth[own] = (depth.get(own, 0) + factor * a) % P
            places.append((x, depth))
        ends = []
        for point, pair in zip(self.lines, lines):
            ends.append([])
            for x in pair if point is None else pair[1:]:
                ends[-1].append(len(places))
                places.append((x, {next(count): 1}))
        return places, ends, next(count)

    def equations(self, ends):
        """What another view shows: image lines, and places that are on them."""
        points, _, lines = self.image()
        found = []
        for i, (x, carrier) in enumerate(zip(points, self.carriers)):
            found += [(cross(x, self.vector()), i) for _ in range(1 if carrier else 2)]
        for (a, b), places in zip(lines, ends):
            found += [(cross(a, b), place) for place in places]
        return found


def resection(places, equations):
    """The rows of N, and those that times -t are the nine entries of M: three linear forms each."""
    by_m = [[a * b % P for a in line for b in places[place][0]] for line, place in equations]
    identity = [[int(i == j) for j in range(len(by_m))] for i in range(len(by_m))]
    rows = []
    for combination in reduced([a + b for a, b in zip(by_m, identity)], 9):
        row = [{}, {}, {}]
        for factor, (line, place) in zip(combination[9:], equations):
            for form, a in zip(row, line):
                for own, b in places[place][1].items():
                    form[own] = (form.get(own, 0) + factor * a * b) % P
        rows.append(row)
    return rows[9:], rows[:9]


def mixed(rows, count, dice):
    """Random combinations of rows of forms."""
    found = []
    for _ in range(count):
        factors = [dice.randrange(P) for _ in rows]
        owns = {own for row in rows for form in row for own in form}
        found.append([{own: sum(f * row[i].get(own, 0) for f, row in zip(factors, rows)) % P for own in owns}
                      for i in range(3)])
    return found


VIEW = """
proc camera(matrix a, matrix m, ideal G) {
  matrix t[3][1] = a[1,2]*a[2,3]-a[1,3]*a[2,2], a[1,3]*a[2,1]-a[1,1]*a[2,3], a[1,1]*a[2,2]-a[1,2]*a[2,1];
  matrix q[3][3] = reduce(ideal(m*t), G);
  poly x = reduce(q[2,2]*q[3,3]-q[2,3]*q[3,2], G);
  poly y = reduce(q[2,3]*q[3,1]-q[2,1]*q[3,3], G);
  poly z = reduce(q[2,1]*q[3,2]-q[2,2]*q[3,1], G);
  return(reduce(q[1,1]*x+q[1,2]*y+q[1,3]*z, G));
}
"""


def program(views, features, dice):
    """What Singular has to do, by depths."""
    problem = Problem(features, dice)
    places, ends, depths = problem.places()
    own = {next(iter(depth)): x for x, depth in reversed(places) if list(depth.values()) == [1]}
    zero = next(three for three in itertools.combinations(range(depths), 3)
                if determinant([own[i] for i in three]))
    rest = [i for i in range(depths) if i not in zero]
    names = dict(zip(rest, ["1"] + [f"d{i}" for i in rest[1:]]))

    def matrix(name, rows):
        forms = ("+".join(f"{a}*{names[own]}" for own, a in form.items() if own in names) or "0"
                 for row in rows for form in row)
        return f"matrix {name}[{len(rows)}][3] = {','.join(forms)};\n"

    text = f"ring r = {P}, ({','.join(['w', 'z'] + list(names.values())[1:])}), dp;\n" + VIEW
    further, _ = resection(places, problem.equations(ends))
    text += "ideal G;\n"
    # Fewer than three rows: a camera sees each scene. So there is one scene.
    if len(further) < 3:
        text += "G = z;\n"
    else:
        text += matrix("f", mixed(further, 3, dice)) + "G = z*det(f)-1;\n"
    for view in range(1, views):
        rows, entries = resection(places, problem.equations(ends))
        text += matrix("n", rows) + matrix(f"a{view}", mixed(rows, 2, dice)) + matrix(f"m{view}", entries)
        text += ("G = G+minor(n,3);\n" if len(rows) >= 3 else "") + "kill n;\n"
    text += "G = std(G); poly g = 1;\n"
    for view in range(1, views):
        text += f"g = reduce(g*camera(a{view},m{view},G), G);\n"
    return text + "G = std(G+ideal(w*g-1));\n"


# Cameras with a known vertical, or an unknown focal length: what each of them has, K R inverse(K) for the focal
# length f of camera 1, and what is not 0. e is f^2, and s the sine of the angle, divided by f. A quaternion is
# (1, f i, f j, k), up to a factor.
TURN = "{r}*c{v},0,{r}*e*s{v}, 0,{r},0, -s{v},0,c{v}"
QUATERNION = ("1+e*i{v}^2-e*j{v}^2-k{v}^2, 2*e*i{v}*j{v}-2*k{v}, 2*e*(i{v}*k{v}+j{v}),"
              "2*e*i{v}*j{v}+2*k{v}, 1-e*i{v}^2+e*j{v}^2-k{v}^2, 2*e*(j{v}*k{v}-i{v}),"
              "2*(i{v}*k{v}-j{v}), 2*(j{v}*k{v}+i{v}), 1-e*i{v}^2-e*j{v}^2+k{v}^2")


def program_of_known_parts(kind, views, features, dice):
    """What Singular has to do, by depths, rotations and translations."""
    problem = Problem(features, dice)
    places, ends, depths = problem.places()
    focal, own = kind not in ("", "upright"), kind == "upright-focal"
    turns = kind.startswith("upright")
    names = ["z"] + ["e"] * focal
    ideal, units = [], ["e"] * focal
    matrices = ""
    for v in range(1, views):
        names += [f"{name}{v}" for name in ("cs" if turns else "ijk")] + [f"r{v}"] * own
        names += [f"{name}{v}" for name in "tuw"]
        entries = (TURN if turns else QUATERNION).format(v=v, r=f"r{v}" if own else "1")
        matrices += f"matrix m{v}[3][3] = {entries if focal else entries.replace('e*', '')};\n"
        e = "e*" if focal else ""
        if turns:
            ideal.append(f"c{v}^2+{e}s{v}^2-1")
            units += [f"r{v}"] * own
        else:
            units.append(f"(1+{e}i{v}^2+{e}j{v}^2+k{v}^2)")
    names += [f"d{own_depth}" for own_depth in range(depths)]
    ideal.append("+".join(f"{dice.randrange(1, P)}*{name}" for name in ["t1", "u1", "w1"]) + "-1")
    for v in range(1, views):
        for line, place in problem.equations(ends):
            x, depth = places[place]
            far = "+".join(f"{a}*d{own_depth}" for own_depth, a in depth.items())
            ideal.append("+".join(
                f"{l}*({'+'.join(f'{a}*m{v}[{i + 1},{j + 1}]' for j, a in enumerate(x))}+({far})*{t}{v})"
                for i, (l, t) in enumerate(zip(line, "tuw"))))
    ideal.append("z*" + "*".join(units) + "-1" if units else "z")
    return f"ring r = {P}, ({','.join(names)}), dp;\n{matrices}ideal G = {','.join(ideal)};\nG = std(G);\n"


def matchings(lines):
    """The ways to make pairs of these."""
    if not lines:
        return [[]]
    return [[(lines[0], other)] + rest for other in lines[1:]
            for rest in matchings([line for line in lines[1:] if line != other])]


def program_of_six_lines(views, dice):
    """What Singular has to do, by products of lines."""
    pairs = list(itertools.combinations(range(6), 2))
    products = matchings(list(range(6)))

    def vector(size):
        return [dice.randrange(1, P) for _ in range(size)]

    def invariants(scene):
        gram = {(i, j): determinant(scene[i] + scene[j]) for i, j in pairs}
        values = [gram[one] * gram[two] * gram[three] % P for one, two, three in products]
        coordinates = [[(a[i] * b[j] - a[j] * b[i]) % P for i, j in itertools.combinations(range(4), 2)]
                       for a, b in scene]
        return values + [determinant(coordinates)]

    def condition(image, scene):
        """That some camera sees the scene so."""
        return determinant([[a * b % P for a in line for b in place]
                            for line, places in zip(image, scene) for place in places])

    scenes = [[[vector(4), vector(4)] for _ in range(6)] for _ in range(20)]
    values = [invariants(scene) for scene in scenes]
    # By a motion of each line's coordinates some products are 1.
    ones = {(0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (1, 2)}
    name = {pair: "1" if pair in ones else f"g{pair[0]}{pair[1]}" for pair in pairs}
    terms = ["*".join(name[pair] for pair in three) for three in products] + ["x"]
    equations = []
    for _ in range(views + 1):
        image = [vector(3) for _ in range(6)]
        rows = reduced([row + [condition(image, scene)] for row, scene in zip(values, scenes)], 16)
        if any(any(row) for row in rows[16:]):
            sys.exit("the condition on six lines is no sum of the invariants")
        equations.append("+".join(f"{row[16]}*{term}" for row, term in zip(rows, terms)))
    gram = ",".join("0" if i == j else name[min(i, j), max(i, j)] for i in range(6) for j in range(6))
    variables = [variable for variable in name.values() if variable != "1"]
    # The last condition is that of a further image, which is not met.
    return (f"ring r = {P}, ({','.join(['z', 'x'] + variables)}), dp; matrix g[6][6] = {gram};\n"
            f"ideal G = {','.join(equations[:views])}, x^2+det(g), z*({equations[views]})-1; G = std(G);\n")


def count_of(text):
    """How many zeros the ideal G has that Singular computes so; what it says, if it does not find
    finitely many."""
    text += 'print("COUNT "+string(dim(G))+" "+string(vdim(G)));\nquit;\n'
    run = subprocess.run(["Singular", "-q"], input=text, capture_output=True, text=True, check=False)
    dimension, _, count = run.stdout.rpartition("COUNT ")[2].strip().partition(" ")
    return int(count) if dimension == "0" else run.stdout[-500:]


def degree(notation):
    """How many solutions there are; what Singular says instead, if it does not find finitely many."""
    kind, views, features = read_problem(notation)
    dice = random.Random(notation)
    if kind != "projective":
        text = program_of_known_parts(kind, views, features, dice)
    elif (views, features) == SIX_LINES:
        text = program_of_six_lines(views, dice)
    else:
        text = program(views, features, dice)
    return count_of("option(redSB); option(noredefine);\n" + text)


def is_chosen(family, problem, solutions, quick):
    if family == "projective":
        return not quick or read_problem(problem)[2].count("a") < MANY_FREE_LINES
    return family in IN_PART and solutions <= (FEW_IN_PART if quick else MOST_IN_PART)


def compare(known, count, how):
    """Whether counting the solutions of some problem finds another number than is known, or there is none."""
    wrong = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as threads:
        for problem, found in zip(known, threads.map(count, known)):
            if found != known[problem]:
                print(f"{problem}: {found}, on file {known[problem]}", flush=True)
                wrong += 1
    print(f"{len(known)} degrees {how}, {wrong} of them differ from those on file")
    return wrong > 0 or not known


def main():
    quick = sys.argv[2:] == ["quick"]
    known = {}
    with open(sys.argv[1], encoding="utf-8") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            if is_chosen(row["family"], row["problem"], int(row["degree"]), quick):
                known[row["problem"]] = int(row["degree"])
    return compare(known, degree, "by Groebner bases")


if __name__ == "__main__":
    sys.exit(main())
