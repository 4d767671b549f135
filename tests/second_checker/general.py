"""Sections 1 and 13: features as text, problems, their dimensions, the Jacobian."""

import re
from itertools import combinations

from algebra import Sum, apply, cross, dot
from cameras import KINDS, dimension, matrices
from grammar import Fault

LETTER = "[A-OQ-Za-z]"
NAME = re.compile(f"((?:P{LETTER}*|{LETTER}|-)(?:/(?:P{LETTER}*|{LETTER}|-))+)"
                  f"(?:\\((P{LETTER}*|{LETTER}+)\\))?")


def parse(name):
    """(number of views, the views that see the point, or None, {letter: the views that see it}).

    Views are counted from 0, here and below. A free line has no point and one letter."""
    match = NAME.fullmatch(name)
    if not match:
        raise Fault(f"{name} is no feature")
    symbols, hidden = match[1].split("/"), match[2] or ""
    letters = {letter: frozenset(v for v, text in enumerate(symbols) if letter in text)
               for letter in sorted(set(match[1] + hidden) - set("P-/"))}
    point = frozenset(v for v, text in enumerate(symbols) if "P" in text)
    is_point = bool(point) or "P" in hidden or len(letters) > 1
    if any(text != "".join(sorted(set(text), key=lambda c: (c != "P", c)))
           for text in symbols + [hidden]) or \
            not is_point and not (letters and min(letters).islower()) or \
            {x for x, views in letters.items() if not views} != set(hidden) - {"P"} or \
            ("P" in hidden) != (is_point and not point and len(letters) < 2):
        raise Fault(f"{name} is not spelled as it should be")
    return len(symbols), point if is_point else None, letters


def multiplicities(text):
    """[(multiplicity, feature as text)] of a notation."""
    found = []
    for term in text.split(" + "):
        match = re.fullmatch(r"(?:([1-9]\d{0,3})\*)?([^*]+)", term)
        if not match or match[1] and not 2 <= int(match[1]) <= 1000 or \
                found and found[-1][1] == match[2]:
            raise Fault(f"{term}: its multiplicity, or equal neighbours")
        found.append((int(match[1] or 1), match[2]))
    return found


class Problem:
    """`points[i]` and `lines[j]` are the sets of views that see them; `on[j]` lists the points of a
    line, ascending; `carrier[i]` is the line with two earlier points on it, or None."""

    def __init__(self, features, views, cameras="calibrated"):
        """Of features as (point, {letter: views}), copies written out."""
        self.views, self.cameras = views, cameras
        self.points, self.lines, self.on, self.shared = [], [], [], {}
        for point, letters in features:
            if point is not None:
                self.points.append(point)
            for letter, seen in letters.items():
                self.add_line(letter, seen, point)
        carriers = [[j for j, on in enumerate(self.on) if i in on[2:]]
                    for i in range(len(self.points))]
        if any(len(lines) > 1 for lines in carriers) or \
                any(n < 2 for _, n in self.shared.values()):
            raise Fault("a point with two carriers, or a capital letter in one feature only")
        self.carrier = [lines[0] if lines else None for lines in carriers]

    def add_line(self, letter, seen, point):
        line, copies = self.shared.get(letter, (len(self.lines), 0))
        if letter.isupper():
            self.shared[letter] = line, copies + 1
        if line == len(self.lines):
            self.lines.append(seen)
            self.on.append([])
        if self.lines[line] != seen:
            raise Fault(f"the views that see {letter}")
        if point is not None:
            self.on[line].append(len(self.points) - 1)

    def dimensions(self, points=None, lines=None, views=None):
        """(in space, in the views) of the problem or of a part; its lines have points of it only."""
        if points is None:
            points, lines = range(len(self.points)), range(len(self.lines))
        views = views or range(self.views)
        on = {j: [i for i in self.on[j] if i in points] for j in lines}
        space = 3 * len(points) + sum(4 - 2 * n for n in map(len, on.values()))
        seen = sum(2 * sum(v in self.points[i] for i in points) +
                   sum(2 - sum(v in self.points[i] for i in on[j])
                       for j in lines if v in self.lines[j]) for v in views)
        return space, seen

    @property
    def projective(self):
        return self.cameras == "projective"

    def balanced(self):
        space, seen = self.dimensions()
        return space + dimension(self.cameras, self.views) == seen

    def sees_everything(self):
        return all(len(seen) == self.views for seen in self.points + self.lines)


def general_problem(text):
    """The problem of a NOTATION of section 13, if it conforms."""
    features, views = [], set()
    prefix, _, terms = text.rpartition(": ")
    if prefix and (prefix not in KINDS or prefix == "calibrated"):
        raise Fault(f"{prefix} are no cameras")
    for count, name in multiplicities(terms):
        of_views, point, letters = parse(name)
        features += [(point, letters)] * count
        views.add(of_views)
    if len(views) > 1 or max(views) > 12:
        raise Fault("the number of views")
    problem = Problem(features, max(views), prefix or "calibrated")
    if len(problem.points) > 100 or len(problem.lines) > 100 or \
            any(len(set(a) & set(b)) > 1 for a, b in combinations(problem.on, 2)):
        raise Fault("too many points or lines, or two lines that share two points")
    for view in range(problem.views):
        for line, on in zip(problem.lines, problem.on):
            if view not in line and sum(view in problem.points[i] for i in on) > 1:
                raise Fault("a view sees two points of a line, but not the line")
        for i, point in enumerate(problem.points):
            seen = sum(i in on and view in line for line, on in zip(problem.lines, problem.on))
            if view not in point and seen > 1:
                raise Fault("a view sees two lines of a point, but not the point")
    return problem


class Chart:
    """Numbers with first derivatives by the unknowns; a column of J for each unknown."""

    def __init__(self):
        self.width = 0

    def moving(self, values, left_out=0):
        """The values, each but the first few plus an unknown of its own."""
        found = []
        for i, value in enumerate(values):
            motion = {self.width: 1} if i >= left_out else {}
            found.append(Sum({None: value, **motion}, lambda a, b: []))
            self.width += len(motion)
        return found


def value(vector):
    return [x.terms.get(None, 0) for x in vector]


def scene_of(problem, integers, chart):
    """(points, lines as pairs A, E), with their motions."""
    numbers, points, lines = iter(integers), [], []

    def place(kept=3):
        at = [next(numbers) for _ in range(3)]
        return chart.moving(at[:kept]) + [Sum({None: x}, None) for x in at[kept:]]

    for carrier in problem.carrier:
        if carrier is None:
            points.append(place())
        else:
            a, b = (points[i] for i in problem.on[carrier][:2])
            s, = chart.moving([next(numbers)])
            points.append([x + s * (y - x) for x, y in zip(a, b)])
    for on in problem.on:
        start = points[on[0]] if on else place(2)
        lines.append((start, place(2) if len(on) < 2 else
                      [y - x for x, y in zip(start, points[on[1]])]))
    return points, lines


def jacobian(problem, cameras, scene, shared=()):
    """J of section 13 at a point; of a single feature it is that of section 3, too."""
    chart, rows = Chart(), []
    points, lines = scene_of(problem, scene, chart)
    seen_by = matrices(problem.cameras, shared, cameras, chart)

    def equation(line, image):
        terms = dot(line, image).terms
        rows.append([terms.get(column, 0) for column in range(chart.width)])

    for view, matrix in enumerate(seen_by):
        for i, point in enumerate(points):
            if view in problem.points[i]:
                image = apply(matrix, point + [1])
                x = value(image)
                equation([0, x[2], -x[1]], image)
                if not any(i in on and view in problem.lines[j] and
                           sum(view in problem.points[k] for k in on[:on.index(i)]) >= 2
                           for j, on in enumerate(problem.on)):
                    equation([-x[2], 0, x[0]], image)
        for j, (start, end) in enumerate(lines):
            seen = sum(view in problem.points[i] for i in problem.on[j])
            if view in problem.lines[j] and seen < 2:
                a, e = apply(matrix, start + [1]), apply(matrix, end + [0])
                line = cross(value(a), value(e))
                if not seen:
                    equation(line, a)
                equation(line, e)
    return rows, chart.width
