"""Section 13: files of problems, and their records."""

from algebra import determinant
from cameras import IN_PART, counts
from families import family_classes, family_numbers, member
from general import general_problem, jacobian
from grammar import Fault, require
from parts import by_directions, by_pencils, conditions


class Record:
    """A general-record: its problem, and what it claims."""

    def __init__(self, node):
        self.notation, = node["GENERAL"]
        self.problem = general_problem(self.notation)
        self.kind, (self.claim,) = next((kind, node[kind]) for kind in node if "record" in kind)
        self.minimal = self.kind == "rank-record"
        if self.minimal:
            self.require_counts()
        motions = self.claim["motion"]
        if any(len(motion["element"]) > 24 for motion in motions):
            raise Fault("more than 24 elements")
        for part in (self.claim, *self.claim["part"], *motions,
                     *(node for motion in motions for node in motion["moved"] + motion["core"]),
                     *(node for motion in motions for element in motion["element"]
                       for node in (element, element["centre"][0]))):
            joined = [point for joins in part["joins"] for point in joins["JOINED"]]
            if max(part["POINT"] + joined, default=0) > len(self.problem.points) or \
                    max(part["LINE"], default=0) > len(self.problem.lines) or \
                    max(part["VIEW"], default=0) > self.problem.views:
                raise Fault("a POINT, LINE or VIEW that the problem lacks")

    def require_counts(self):
        problem = self.problem
        self.cameras = [camera["INT"] for camera in self.claim["camera"]]
        scene = sum(3 if carrier is None else 1 for carrier in problem.carrier)
        scene += sum(6 if not on else 3 for on in problem.on if len(on) < 2)
        self.shared = self.claim["shared"][0]["INT"] if self.claim["shared"] else []
        of_all, of_one = counts(problem.cameras)
        if [len(camera) for camera in self.cameras] != [of_one] * (problem.views - 1) or \
                len(self.shared) != of_all or len(self.claim["INT"]) != scene:
            raise Fault("the number of cameras, or of integers")

    def check(self):
        problem, claim = self.problem, self.claim
        if self.minimal:
            require(problem.balanced(), "the problem is not balanced")
            require(not problem.projective or self.cameras[0][:4] == [0, 0, 0, 1], "camera 2")
            if problem.cameras in IN_PART:
                turn = IN_PART[problem.cameras][1]
                require(all(any(camera[:turn]) for camera in self.cameras) and
                        self.cameras[0][turn] != 0, "a turn 0, or a translation that begins with 0")
            rows, _ = jacobian(problem, self.cameras, claim["INT"], self.shared)
            require(determinant(rows) == claim["MINOR"][0], "the determinant")
        elif self.kind == "count-record":
            require(not problem.balanced(), "the problem is balanced")
        elif self.kind == "collinear-record":
            four, pair = from_zero(claim["POINT"]), from_zero(claim["VIEW"])
            require(any(four <= set(on) for on in problem.on) and
                    all(pair <= problem.points[i] for i in four), "four points")
        else:
            motion, = claim["motion"]
            words, part = motion["words"][1:], named(claim["part"][0])
            core = named(motion["core"][0]) if motion["core"] else None
            points, lines = from_zero(motion["POINT"]), from_zero(motion["LINE"])
            if "directions" in words:
                joined = [point - 1 for joins in motion["joins"] for point in joins["JOINED"]]
                joins = list(zip(joined[::2], joined[1::2]))
                found = by_directions(problem, part, words, joins, core)
            elif "pencils" in words:
                found = by_pencils(problem, part, words, *points)
            elif "loose" in words:
                found = conditions(problem, part, words, (points, lines))
            elif "camera" in words:
                found = conditions(problem, part, words, from_zero(motion["VIEW"]))
            elif "star" in words:
                star, = points
                views, *generators = named(motion["moved"][0])
                elements = [("point", star, {view}, generators) for view in views]
                found = conditions(problem, part, words, elements)
            elif "central" in words:
                found = conditions(problem, part, words, elements_of(motion, points, lines))
            else:
                found = conditions(problem, part, words,
                                   named(motion["moved"][0]) if motion["moved"] else None)
            require(found == claim["CONDITIONS"][0], "CONDITIONS")


def from_zero(numbers):
    return {number - 1 for number in numbers}


def named(node):
    """The sets of views, points and lines of a `part` or `moved`."""
    return [from_zero(node[name]) for name in ("VIEW", "POINT", "LINE")]


def elements_of(motion, points, lines):
    """The elements of a central motion with these generators of all: the kind of a centre, its
    number, the moving views, (points, lines) that generate."""
    found = []
    for element in motion["element"]:
        centre, = element["centre"]
        number, = centre["POINT"] + centre["LINE"] + centre["VIEW"]
        generators = points | from_zero(element["POINT"]), lines | from_zero(element["LINE"])
        found.append((centre["words"][0], number - 1, from_zero(element["VIEW"]), generators))
    return found


class File:
    def __init__(self, node):
        self.family = node["family"][0]["words"][1] if node["family"] else None
        self.records = [Record(record) for record in node["general-record"]]
        self.seen = set()
        self.refused = 0

    def check(self, record):
        require(self.refused < 100, "100 records are refused before it")
        self.refused += 1
        place = member(self.family, record.problem) if self.family else record
        require(place is not None and place not in self.seen, "not of the family, or there already")
        record.check()
        self.refused -= 1
        self.seen.add(place)

    def conclude(self, held):
        """(how many problems of the family have no record that holds, the numbers of the family)."""
        missing = len(family_classes(self.family) - self.seen) if self.family else 0
        return missing, family_numbers(self.family, held) if self.family and not missing else {}
