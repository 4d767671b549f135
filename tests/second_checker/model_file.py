"""Section 16, files of models: fibres and eliminations."""

import itertools
import math
import random

from fibre import cycle_type, group_shown, is_regular, read_fibre
from grammar import Q, require
from model import FUNCTIONS, RESERVED, Execution, depth_of, need, scalars
from model_rings import LARGE, Constants, Large, Polynomial, Tangent, determinant, is_zero, plus


class Record:
    """A fibre, which proves `at least` so many solutions; or an elimination, or the count of fewer
    equations than unknowns: `at most`."""

    def __init__(self, kind, node):
        self.kind, self.node, self.number = kind, node, None


class File:
    def __init__(self, node):
        self.model, = node["model"]
        need(depth_of(self.model) <= 100, "more than 100 sums and loops in each other")
        need(not any(declares_in_loop(statement) for statement in self.model["statement"]),
             "data and unknowns in a loop")
        name, = self.model["NAME"]
        need(name not in RESERVED and name not in FUNCTIONS, f"the name {name}")
        self.data, self.unknowns = self.declared("data"), self.declared("unknown")
        self.size, self.unknown_size = sum(self.data.values()), sum(self.unknowns.values())
        need(self.size <= 1000 and 1 <= self.unknown_size <= 100, "too many scalars, or no unknown")
        dice = random.Random(1)
        place = {name: [Large.Element(dice.randrange(LARGE)) for _ in range(count)]
                 for name, count in {**self.data, **self.unknowns}.items()}
        self.there = Execution(self.model, Large(), place)
        need(len(self.there.equations) <= 1000, "too many equations")
        self.values = {}  # of a fibre that holds: a polynomial with a root for each value that counts
        self.relations_hold = not any(self.there.relations)
        is_small = len(self.there.equations) < self.unknown_size
        self.records = [Record("count", None)] * is_small + [
            Record(kind, record) for kind in ("fibre", "elimination") for record in self.model[kind]]
        for record in self.model["fibre"]:
            self.require_conforming_fibre(record)
        for record in self.model["elimination"]:
            self.require_conforming_elimination(record)

    def declared(self, kind):
        """{name: how many scalars it has}."""
        return {variable["NAME"][0]: math.prod(variable["SIZE"]) for statement in self.model["statement"]
                if statement["words"][0] == kind for variable in statement["variable"]}

    def require_conforming_fibre(self, node):
        lines, (count, *distinct) = node["fibre-lines"][0], node["COUNT"]
        residues = lines["polynomial"] + lines["unknown"]
        counted = len(self.there.counted)
        need(count <= 10000 and all(len(line["RESIDUE"]) == count for line in residues), "its degree")
        need(len(node["RESIDUE"]) == self.size, "the data of a fibre")
        need(len(lines["unknown"]) == len(lines["INT"]) == self.unknown_size, "unknowns of a fibre")
        need(len(node["INT"]) == counted and len(distinct) == bool(counted), "what counts in a fibre")
        need(not distinct or distinct[0] <= count, "more values than solutions")

    def require_conforming_elimination(self, node):
        need(len(node["RESIDUE"]) == self.size, "the data of an elimination")
        for group in node["group"]:
            names = group["NAME"]
            need(set(names) <= self.there.values.keys() - self.data.keys(), "the names of a group")
        equations = [row["EQUATION"][0] for row in node["rows"]]
        need(all(a < b for a, b in itertools.pairwise(equations)), "equations do not ascend")

    def check(self, record):
        check = {"fibre": self.bound_below, "elimination": self.bound_above, "count": lambda _: 0}
        record.number = check[record.kind](record.node)

    def bound_below(self, node):
        require(len(self.there.equations) == self.unknown_size, "not as many equations as unknowns")
        ring, unknowns = read_fibre(node)
        one = ring.number([1])
        values = [Tangent(x, {k: one}) for k, x in enumerate(unknowns)]
        given = dealt(self.data, [Tangent(x, {}) for x in node["RESIDUE"]]) | dealt(self.unknowns, values)
        found = Execution(self.model, Constants(lambda number: Tangent(number % Q, {})), given)
        require(all(is_zero(x.value) for x in found.equations), "an equation")
        require(not any(ring.has_common_root(x.value) for x in found.conditions), "a condition")
        rows = [[ring.number([0]) + x.change.get(k, 0) for k in range(len(unknowns))]
                for x in found.equations]
        require(is_regular(ring, rows), "a singular Jacobian")
        if not node["INT"]:
            self.values[id(node)] = ring.g
            return ring.size
        total = ring.number([0])
        for factor, scalar in zip(node["INT"], found.counted):
            value = one * scalar.numerator.value
            for divisor, power in scalar.denominator.items():
                for _ in range(power):
                    value = value * (one * found.divisors[divisor].value).inverse()
            total = total + value * factor
        count = node["COUNT"][1]
        powers = itertools.accumulate(range(1, count + 1), lambda power, _: power * total, initial=one)
        relation = first_relation([power.c for power in powers])
        require(relation is None or len(relation) > count, "values that are not distinct")
        self.values[id(node)] = relation
        return count

    def bound_above(self, node):
        require(self.relations_hold, "a relation")
        groups = [(group["POWER"][0], group["NAME"]) for group in node["group"]]
        most, names = [power for power, _ in groups], dict.fromkeys(sum((own for _, own in groups), []))
        sizes = {name: len(scalars(self.there.values[name])) for name in names}
        degrees = [tuple(own.count(name) for _, own in groups)
                   for name in names for _ in range(sizes[name])]
        none, zero = (0,) * len(groups), (0,) * len(degrees)
        units = [tuple(int(i == k) for i in range(len(degrees))) for k in range(len(degrees))]
        variables = [Polynomial({unit: 1}, own) for unit, own in zip(units, degrees)]

        def number(value, is_datum=False):
            return Polynomial({zero: value % Q} if value % Q else {}, none if value or is_datum else None)

        given = {name: [Polynomial({}, none, True)] * size for name, size in self.unknowns.items()}
        given |= dealt(self.data, [number(x, True) for x in node["RESIDUE"]]) | dealt(sizes, variables)
        found = Execution(self.model, Constants(number), given)
        for scalar in found.counted:
            parts = [scalar.numerator, *(found.divisors[divisor] for divisor in scalar.denominator)]
            require(not any(part.is_foreign for part in parts), "what counts has another unknown")
        require(found.counted or self.unknowns.keys() <= names.keys(), "an unknown is no variable")

        columns = columns_within(degrees, most)
        places = {powers: place for place, (powers, _) in enumerate(columns)}
        for place in node["MONOMIAL"]:
            require(place <= len(columns), "no such monomial")
            powers, own = columns[place - 1]
            require(all(a + b <= c for unit in degrees for a, b, c in zip(own, unit, most)),
                    "a monomial of the basis, times a variable")
            del places[powers]
        numbers = {powers: k for k, powers in enumerate(places)}
        equations, rows = found.equations + found.relations, []
        for line in node["rows"]:
            require(line["EQUATION"][0] <= len(equations), "no such equation")
            equation = equations[line["EQUATION"][0] - 1]
            require(not equation.is_foreign, "an equation with another unknown")
            for place in line["MONOMIAL"]:
                require(place <= len(columns), "no such monomial")
                powers, own = columns[place - 1]
                total = plus(own, equation.degrees or none)
                require(equation.degrees is None or all(a <= b for a, b in zip(total, most)), "a degree")
                terms = ((numbers.get(plus(powers, term)), x) for term, x in equation.terms.items())
                rows.append({column: x for column, x in terms if column is not None})
        require(len(rows) == len(numbers), "the number of rows")
        require(determinant(rows) == node["MINOR"][0], "the minor")
        return len(node["MONOMIAL"])

    def conclude(self, held):
        bounds = bounds_of(held)
        return 0, bounds | {"group": self.group(held, bounds)}

    def group(self, held, bounds):
        """What is certified of the group; None if nothing."""
        degree = bounds.get("at least")
        if degree is None or degree != bounds.get("at most"):
            return None
        fibres = [record for record in held if record.kind == "fibre" and record.number == degree]
        types = [cycle_type(self.values[id(record.node)]) for record in fibres if len(fibres) > 1]
        return group_shown(types, degree, one_orbit=False)


def first_relation(rows):
    """The first combination of rows that is 0, as a list of factors, the last one 1; or None."""
    echelon = {}  # pivot: row, and the factors of its rows
    for k, row in enumerate(rows):
        row, factors = list(row), [0] * k + [1]
        for pivot, (other, own) in echelon.items():
            scale = row[pivot]
            if scale:
                row = [(x - scale * y) % Q for x, y in zip(row, other)]
                factors = [(x - scale * y) % Q for x, y in itertools.zip_longest(factors, own, fillvalue=0)]
        place = next((i for i, x in enumerate(row) if x), None)
        if place is None:
            return factors
        inverse = pow(row[place], -1, Q)
        echelon[place] = [x * inverse % Q for x in row], [x * inverse % Q for x in factors]
    return None


def declares_in_loop(statement):
    """Whether a loop, or one in it, has a statement `data` or `unknown`."""
    return any(own["words"][0] in ("data", "unknown") or declares_in_loop(own)
               for own in statement["statement"])


def bounds_of(held):
    """What records prove, by what they say: {"at least": the largest number, "at most": the smallest}."""
    at_least = [record.number for record in held if record.kind == "fibre"]
    at_most = [record.number for record in held if record.kind != "fibre"]
    return ({"at least": max(at_least)} if at_least else {}) | \
        ({"at most": min(at_most)} if at_most else {})


def dealt(sizes, elements):
    """{name: its elements}, of all in order."""
    rest = iter(elements)
    return {name: list(itertools.islice(rest, size)) for name, size in sizes.items()}


def columns_within(degrees, most):
    """The monomials: (exponents, degrees), in ascending lexicographic order."""
    found = [((), (0,) * len(most))]
    for own in degrees:
        longer = []
        for powers, total in found:
            power = 0
            while all(a <= b for a, b in zip(total, most)):
                longer.append((powers + (power,), total))
                power, total = power + 1, plus(total, own)
            require(len(longer) <= 4000, "too many columns")
        found = longer
    return found
