"""Section 10: templates, which bound the number of registrations."""

from itertools import combinations, product

from algebra import Sum, apply, cross, determinant, dot, quaternion_matrix
from grammar import Fault, chunks, require


FRAMES = ("general", "line", "points", "lines")


def pairs(nodes):
    return [chunks(node["INT"], 3) for node in nodes]


def fits(degree, most):
    return all(a <= b for a, b in zip(degree, most))


def add(*degrees):
    return tuple(map(sum, zip(*degrees)))


def minor(rows):
    """The determinant of a small matrix, along its last column."""
    if len(rows) == 1:
        return rows[0][0]
    return sum((-1) ** (i + len(rows) - 1) * row[-1] * minor([r[:-1] for r in rows[:i] + rows[i + 1:]])
               for i, row in enumerate(rows))


class Rotations:
    """Monomials in (w, x, y, z), or else in (c, s, c', s'), as their exponents; and the matrix R."""

    def __init__(self, general):
        # A square of the first of these variables is 1 less the squares of the others.
        self.general = general
        self.squares = [(0, (1, 2, 3))] if general else [(0, (1,)), (2, (3,))]
        self.unit = (1,) if general else (1, 1)
        variables = [Sum({tuple(int(i == j) for j in range(4)): 1}, self.join) for i in range(4)]
        self.variables = c, s, k, u = variables
        self.matrix = quaternion_matrix(*variables) if general else \
            [[c, -(s * k), s * u], [s, c * k, -(c * u)], [0, u, k]]

    def join(self, a, b):
        """The product of two monomials, reduced."""
        return list(self.reduced(tuple(i + j for i, j in zip(a, b)), 1).items())

    def reduced(self, monomial, x):
        terms = {}
        for high, others in self.squares:
            if monomial[high] > 1:
                lower = monomial[:high] + (monomial[high] - 2,) + monomial[high + 1:]
                parts = [(lower, x)]
                parts += [(tuple(e + 2 * (i == other) for i, e in enumerate(lower)), -x)
                          for other in others]
                for part in parts:
                    for key, y in self.reduced(*part).items():
                        terms[key] = terms.get(key, 0) + y
                return terms
        return {monomial if any(monomial) else None: x}

    def degree(self, monomial):
        i, j, k, m = monomial or (0, 0, 0, 0)
        return ((i + j + k + m) // 2,) if self.general else (i + j, k + m)

    def columns(self, most):
        ends = (1, *[2 * most[0]] * 3) if self.general else (1, most[0], 1, most[-1])
        return [m if any(m) else None for m in product(*(range(end + 1) for end in ends))
                if (not self.general or sum(m) % 2 == 0) and fits(self.degree(m), most)]


class Condition:
    """coefficients · t + free = 0; `degree` of the free term, None if it has none."""

    def __init__(self, coefficients, free, degree, ray=False, axis=False):
        self.coefficients, self.free, self.degree = coefficients, free, degree
        self.ray, self.axis = ray, axis


class Template:
    """`stars` are (point, image, pins), `groups` (point, rays): pins and rays are pairs of vectors.
    `lines` are (point, direction, image), `incidences` (point, line)."""

    def __init__(self, node):
        self.frame = next(word for word in node["words"] if word in FRAMES)
        self.most, self.minor = tuple(node["DEGREE"]), node["MINOR"][0]
        self.basis = node["MONOMIAL"]
        self.rows = [(row["EQUATION"][0], row["MONOMIAL"]) for row in node["rows"]]
        self.stars = [(*chunks(star["INT"], 3), pairs(star["pin"])) for star in node["star"]]
        self.lines = [tuple(chunks(line["INT"], 3)) for line in node["line"]]
        self.incidences = [tuple(chunks(meets["INT"], 3)) for meets in node["incidence"]]
        self.groups = [(group["INT"], pairs(group["ray"])) for group in node["transversals"]]
        self.ring = Rotations(self.frame == "general")
        numbers = [number for number, _ in self.rows]
        if any(a >= b for a, b in zip(numbers, numbers[1:])) or \
                any(len(both[-1]) > 6 for both in self.stars + self.groups) or \
                sum(map(len, (self.stars, self.lines, self.incidences, self.groups))) > 6:
            raise Fault("the order of EQUATION, or the number of constraints, pins or rays")

    def type(self):
        return (tuple(sorted(len(pins) for _, _, pins in self.stars)), len(self.lines),
                len(self.incidences), tuple(sorted(len(rays) for _, rays in self.groups)))

    def require(self):
        """Item 1: the weights, what the frame requires, the first star's point."""
        pins, lines, incidences, rays = self.type()
        weight = sum(2 + k for k in pins) + 2 * lines + incidences + sum(rays)
        require(weight == 6 or self.type() == ((), 0, 0, (5,)), "the weights")
        require(not self.stars or not any(self.stars[0][0]), "the point of the first star")
        if self.frame in ("line", "lines"):
            require(self.lines and self.lines[0][1:] == ([1, 0, 0], [0, 0, 1]), "the first line")
        if self.frame == "points":
            require(len(pins) > 1 and not any(x for point, image, _ in self.stars[:2]
                                              for x in (*point[1:], image[2])), "the first stars")
        if self.frame == "lines":
            require((pins, lines, incidences, sum(rays)) == ((), 2, 0, 2), "the constraints")
            (first, _, _), (second, direction, _) = self.lines
            require(not any(first + second[:2] + direction[2:]), "the two lines")

    def rotate(self, vector):
        return apply(self.ring.matrix, vector)

    def conditions(self):
        """The conditions, and for each group the numbers of its own."""
        unit, points, found, groups = self.ring.unit, self.frame == "points", [], []

        def fixed(l, point, degree=unit, axis=False):
            found.append(Condition(l, dot(l, self.rotate(point)) if degree else 0, degree, axis=axis))

        for number, (point, x, _) in enumerate(self.stars):
            degree = unit if number else None
            if points and number < 2:
                if number == 0:
                    fixed([0, 0, 1], point, None, axis=True)
                fixed([-x[1], x[0], 0], point, (1, 0) if number else None)
            else:
                fixed([0, x[2], -x[1]], point, degree)
                fixed([-x[2], 0, x[0]], point, degree)
        for number, (point, _, image) in enumerate(self.lines):
            axis = number == 0 and self.frame in ("line", "lines")
            fixed(image, point, unit if not axis else (0, 1) if self.frame == "line" else None, axis)
        for point, image in self.incidences:
            fixed(image, point)
        for point, rays in self.groups:
            groups.append(range(len(found), len(found) + len(rays)))
            found += [Condition(cross(self.rotate(direction), x),
                                dot(x, self.rotate(cross(point, direction))), unit, ray=True)
                      for direction, x in rays]
        return found, groups

    def degree_of_three(self, three):
        rays = sum(c.ray for c in three)
        first, *rest = (min(rays, 2) * u for u in self.ring.unit)
        return first - (rays == 2 and any(c.axis for c in three)), *rest

    def degree_of_four(self, four):
        sums = [add(c.degree, self.degree_of_three(four[:i] + four[i + 1:]))
                for i, c in enumerate(four) if c.degree]
        return tuple(map(max, zip(*sums)))

    def equations(self):
        """[(polynomial, degree)] in the order of section 10."""
        unit, (conditions, groups) = self.ring.unit, self.conditions()

        def determinants(numbers, count):
            for chosen in sorted(combinations(numbers, count), key=lambda c: c[::-1]):
                rows = [conditions[i] for i in chosen]
                if count == 3:
                    yield minor([c.coefficients for c in rows]), self.degree_of_three(rows)
                else:
                    yield minor([c.coefficients + [c.free] for c in rows]), self.degree_of_four(rows)

        found = [(dot(cross(x, y), self.rotate(direction)), unit)
                 for _, x, pins in self.stars for direction, y in pins]
        for number, (_, direction, image) in enumerate(self.lines):
            if number or self.frame not in ("line", "lines"):
                found.append((dot(image, self.rotate(direction)), unit))
            elif self.frame == "line" and len(self.stars) > 1:
                found.append((self.distance_equation(), (0, 2)))
        for numbers in groups:
            found += determinants(numbers, 3)
        if self.frame == "lines":
            found.append((self.two_lines_equation(conditions), (2, 2)))
        return found + list(determinants(range(len(conditions)), 4))

    def distance_equation(self):
        (_, x, _), (other, y, _) = self.stars[:2]
        a, b = x[2], y[2]
        at_star, at_line = self.rotate(other)[2], self.rotate(self.lines[0][0])[2]
        w = [(at_star - at_line) * (a * q) + at_line * (b * p) for p, q in zip(x, y)]
        return dot(w, w) - (a * b) ** 2 * dot(other, other)

    def two_lines_equation(self, conditions):
        _, ((_, _, h), (a, b, _), l) = self.lines
        (D, x), (E, y) = [ray for _, rays in self.groups for ray in rays]
        c, s, k, u = self.ring.variables  # k and u are c' and s'
        f2, f3, f4 = (conditions[i].free for i in (1, 2, 3))
        d1, d2 = (minor([conditions[i].coefficients for i in (0, 1, ray)]) for ray in (2, 3))
        along = a * (l[0] * c + l[1] * s)
        g = h * E[1] * (b * (l[0] * s - l[1] * c) - along * k) + h * E[2] * (b * l[2] + along * u)
        return g * dot(cross(x, y), self.rotate(D)) \
            - b * y[2] * (f2 * dot(x, self.rotate(cross(E, D)))) - b * (f3 * d2) + b * (f4 * d1)

    def check(self):
        """Items 1 to 4."""
        self.require()
        ring = self.ring
        columns, equations = ring.columns(self.most), self.equations()
        require(self.basis[-1] <= len(columns), "a MONOMIAL of the basis")
        basis = [columns[i - 1] for i in self.basis]
        require(all(fits(add(ring.degree(m), ring.unit), self.most) for m in basis), "item 2")
        place = {m: i for i, m in enumerate(m for m in columns if m not in basis)}
        matrix = []
        for number, monomials in self.rows:
            require(number <= len(equations) and monomials[-1] <= len(columns), "a row's numbers")
            polynomial, degree = equations[number - 1]
            for monomial in (columns[i - 1] for i in monomials):
                require(fits(add(degree, ring.degree(monomial)), self.most), "item 3")
                matrix.append([0] * len(place))
                for m, x in (polynomial * Sum({monomial: 1}, ring.join)).terms.items():
                    if m in place:
                        matrix[-1][place[m]] = x
        require(len(matrix) == len(place) and determinant(matrix) == self.minor, "the minor")


class File:
    def __init__(self, node):
        self.records, self.refused = [Template(template) for template in node["template"]], 0

    def check(self, template):
        require(self.refused < 100, "100 templates are refused before it")
        self.refused += 1
        template.check()
        self.refused -= 1

    def conclude(self, _):
        return 0, {}
