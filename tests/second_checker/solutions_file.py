"""Section 14: files of solutions whose records have fibres."""

from algebra import cross, dot, quaternion_matrix
from cameras import IN_PART, dimension, in_part, unknowns_of_one
from fibre import is_regular, read_fibre
from general import general_problem
from grammar import Fault, Q, require


class Still:
    """A chart in which nothing moves."""

    @staticmethod
    def moving(numbers, _fixed=0):
        return numbers


def camera(kind, shared, own, second):
    """The three rows of [M | t], of the unknowns of one camera."""
    if kind == "projective":
        entries = [0, 0, 0, 1, 1, *own] if second else [1, *own]
        return [entries[i:i + 4] for i in (0, 4, 8)]
    turn = 3 if kind == "calibrated" else IN_PART[kind][1] - 1
    numbers = [1, *own[:turn], *([1] if second else []), *own[turn:]]
    if kind != "calibrated":
        return in_part(kind, shared, numbers, Still, second)
    return [[*row, t] for row, t in zip(quaternion_matrix(*numbers[:4]), numbers[4:])]


class Images:
    """What the views show: image vectors of points, factors of those that are not free, ends of lines."""

    def __init__(self, problem, views):
        self.problem = problem
        self.views = [self.read(list(numbers)) for numbers in views]

    def read(self, numbers):
        problem, points, factors, ends = self.problem, [], [], []
        for carrier in problem.carrier:
            if carrier is None:
                factors.append(None)
                points.append([numbers.pop(0) for _ in range(3)])
                continue
            f, g = numbers.pop(0), numbers.pop(0)
            a, b = (points[i] for i in problem.on[carrier][:2])
            factors.append((f, g))
            points.append([f * x + g * y for x, y in zip(a, b)])
            require(points[-1][2] * a[1] != points[-1][1] * a[2], "the auxiliary line of a point")
        for on in problem.on:
            own = [points[i] for i in on[:2]]
            ends.append(own + [[numbers.pop(0) for _ in range(3)] for _ in range(2 - len(own))])
            require(any(cross(*ends[-1])), "a line without an image")
        require(all(point[2] for point in points), "a third coordinate is 0")
        require(all(abs(x) <= 10**9 for point in points for x in point), "a large coordinate")
        return points, factors, ends

    def places(self):
        """(image vector, depth as {number of an unknown depth: coefficient}) of points, then two for each line."""
        points, factors, ends = self.views[0]
        found, depths = [], 0
        for x, factor, carrier in zip(points, factors, self.problem.carrier):
            if factor is None:
                found.append((x, {depths: 1}))
                depths += 1
                continue
            (a, b), (f, g) = (found[i][1] for i in self.problem.on[carrier][:2]), factor
            found.append((x, {k: f * a.get(k, 0) + g * b.get(k, 0) for k in a.keys() | b.keys()}))
        require(all(abs(c) <= 10**9 for _, depth in found for c in depth.values()), "a large coefficient")
        lines = []
        for on, pair in zip(self.problem.on, ends):
            line = [found[i] for i in on[:2]]
            for x in pair[len(line):]:
                line.append((x, {depths: 1}))
                depths += 1
            lines.append(line)
        return found, lines, depths


class Record:
    def __init__(self, node):
        self.problem = problem = general_problem(node["GENERAL"][0])
        self.views = [view["IMAGE"] for view in node["view"]]
        free, lines = problem.carrier.count(None), [min(2, len(on)) for on in problem.on]
        own = sum(2 - n for n in lines)
        self.fibre, = node["general-fibre"]
        rows, count = self.fibre["fibre-lines"][0], self.fibre["COUNT"][0]
        self.cameras = dimension(problem.cameras, problem.views)
        if len(self.views) != problem.views or \
                any(len(view) != 3 * free + 2 * (len(problem.points) - free) + 3 * own for view in self.views) or \
                count > 10000 or len(rows["unknown"]) != self.cameras + free + own or \
                len(rows["INT"]) != self.cameras or \
                any(len(row["RESIDUE"]) != count for row in rows["polynomial"] + rows["unknown"]):
            raise Fault("the numbers of a view, or the lines of a fibre")

    def check(self):
        problem = self.problem
        require(problem.balanced() and problem.sees_everything(),
                "the problem is not balanced, or a view misses something")
        images = Images(problem, self.views)
        ring, unknowns = read_fibre(self.fibre)
        require(all(value.is_zero() for value in self.values(images, unknowns)), "an equation is not 0")

        def change(k, step):
            moved = self.values(images, [x + step if i == k else x for i, x in enumerate(unknowns)])
            back = self.values(images, [x - step if i == k else x for i, x in enumerate(unknowns)])
            return [x - y for x, y in zip(moved, back)]
        # Equations have at most the degree 4 in each unknown: this is 12 times the derivative.
        columns = [[8 * x - y for x, y in zip(change(k, 1), change(k, 2))] for k in range(len(unknowns))]
        require(is_regular(ring, [list(row) for row in zip(*columns)]), "a singular Jacobian")
        self.check_conditions(ring, images, unknowns)

    def matrices(self, unknowns):
        kind = self.problem.cameras
        of_all = IN_PART[kind][0] if kind in IN_PART else 0
        shared, rest = unknowns[:of_all], unknowns[of_all:self.cameras]
        size, found = unknowns_of_one(kind), []
        second = self.cameras - of_all - size * (self.problem.views - 2)
        while rest:
            own = size if found else second
            found.append(camera(kind, shared, rest[:own], not found))
            rest = rest[own:]
        return found

    def seen(self, matrix, place, unknowns):
        x, depth = place
        d = sum(c * unknowns[self.cameras + k] for k, c in depth.items())
        return [dot(row[:3], x) + row[3] * d for row in matrix]

    def values(self, images, unknowns):
        places, lines, _ = images.places()
        found = []
        for matrix, (points, factors, ends) in zip(self.matrices(unknowns), images.views[1:]):
            for place, y, factor in zip(places, points, factors):
                image = self.seen(matrix, place, unknowns)
                found.append(y[2] * image[1] - y[1] * image[2])
                if factor is None:
                    found.append(y[0] * image[2] - y[2] * image[0])
            for on, line, pair in zip(self.problem.on, lines, ends):
                for place in line[len(on[:2]):]:
                    found.append(dot(cross(*pair), self.seen(matrix, place, unknowns)))
        return found

    def check_conditions(self, ring, images, unknowns):
        def some_unit(*numbers):
            return any(not ring.has_common_root(x % Q if isinstance(x, int) else x) for x in numbers)
        places, lines, _ = images.places()
        for matrix in self.matrices(unknowns):
            columns = [list(column) for column in zip(*matrix)]
            minors = [dot(cross(a, b), c) for a, b, c in
                      ([columns[j] for j in range(4) if j != left_out] for left_out in range(4))]
            require(some_unit(*minors), "a camera of rank less than 3")
            require(all(some_unit(*self.seen(matrix, place, unknowns)) for place in places), "a point at a centre")
            require(all(some_unit(*cross(*(self.seen(matrix, place, unknowns) for place in line))) for line in lines),
                    "a line through a centre")


class File:
    def __init__(self, node):
        self.records = [Record(record) for record in node["solutions-record"]]

    @staticmethod
    def check(record):
        record.check()

    def conclude(self, _held):
        return 0, {}
