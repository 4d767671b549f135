"""Section 13: files of problems, and their records."""

from algebra import determinant
from families import family_classes, family_numbers, member
from general import general_problem, jacobian
from lines import MINOR, MODULUS, Reader, Refused, require
from parts import conditions


class Record:
    """A general-record: its problem, and what it claims."""

    def __init__(self, reader):
        reader.take("problem")
        self.problem = problem = general_problem(reader.rest())
        self.kind = reader.word("minimal", "collinear", "excess", "unbalanced")
        self.minimal = self.kind == "minimal"
        if self.kind == "minimal":
            self.minor, = reader.line(MINOR)
            camera = 12 if problem.projective else 7
            self.cameras = [reader.line("camera", camera)[0] for _ in range(problem.views - 1)]
            count = sum(3 if carrier is None else 1 for carrier in problem.carrier)
            count += sum(6 if not on else 3 for on in problem.on if len(on) < 2)
            self.scene, = reader.take("scene", count)
        elif self.kind == "collinear":
            self.four = self.numbers(reader, problem.points, 4, 4)
            reader.take("views")
            self.pair = self.numbers(reader, range(problem.views), 2, 2)
        elif self.kind == "excess":
            self.excess, = reader.line((1, 999999))
            reader.take("part")
            self.part = self.views_points_lines(reader, 2)
            reader.line()
            reader.take("motion")
            word = reader.word("none", "plane", "star")
            star = reader.integer(1, len(problem.points)) - 1 if word == "star" else None
            self.motion = None if word == "none" else (star, *self.views_points_lines(reader, 1))
        reader.line()

    def numbers(self, reader, numbered, least, most=None):
        return [i - 1 for i in reader.ascending(len(numbered), least, most)]

    def views_points_lines(self, reader, least):
        found = []
        for word, numbered, low in (("views", range(self.problem.views), least),
                                    ("points", self.problem.points, 0),
                                    ("lines", self.problem.lines, 0)):
            reader.take(word)
            found.append(self.numbers(reader, numbered, low))
        return found

    def check(self):
        problem = self.problem
        if self.kind == "minimal":
            require(problem.balanced(), "the problem is not balanced")
            require(not problem.projective or self.cameras[0][:4] == [0, 0, 0, 1], "camera 2")
            rows, _ = jacobian(problem, self.cameras, self.scene)
            require(determinant(rows) == self.minor, "the determinant")
        elif self.kind == "unbalanced":
            require(not problem.balanced(), "the problem is balanced")
        elif self.kind == "collinear":
            require(any(set(self.four) <= set(on) for on in problem.on) and
                    all(set(self.pair) <= problem.points[i] for i in self.four), "four points")
        else:
            require(conditions(problem, self.part, self.motion) == self.excess, "COUNT")


def read(data):
    """(the family or None, the records)."""
    reader, family, records = Reader(data, "problems"), None, []
    if reader.next_is("family"):
        reader.take("family")
        family = reader.word("plmp", "projective")
        reader.line()
    reader.line(MODULUS)
    while not reader.ended():
        records.append(Record(reader))
    return family, records


def check(data, every=1):
    family, records = read(data)
    seen, good, refused = set(), [], []
    for number, record in enumerate(records[::every]):
        try:
            require(len(refused) < 100, "100 records are refused before it")
            place = member(family, record.problem) if family else number
            require(place is not None and place not in seen, "not of the family, or there already")
            record.check()
            seen.add(place)
            good.append(record)
        except Refused as why:
            refused.append(f"record {number * every + 1}: {why}")
    result = {"hold": len(good), "refused": refused}
    if family and every == 1:
        result["missing"] = len(family_classes(family) - seen)
        if not result["missing"]:
            result["claims"] = family_numbers(family, good)
    return result
