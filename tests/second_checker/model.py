"""Section 16, values and statements: executes a model over any ring.

A ring makes an element of an integer (`constant`) and inverts such an element (`inverse`); elements
have + and *. A value is a Scalar or a list of values.
"""

import itertools
import re

from algebra import apply, cross, dot, quaternion_matrix
from grammar import RULES, Fault


def words_in(choices):
    """The words to the letter of a rule."""
    for kind, content in itertools.chain(*choices):
        yield from content if kind == "word" else words_in(content) if kind in "{[(" else ()


RESERVED = {word for rule in ("model", "statement", "variable") for word in words_in(RULES[rule])
            if re.match("[a-z]", word)} - {"modulus"}
FUNCTIONS = {"dot": 2, "norm2": 1, "cross": 2, "skew": 1, "det": 1, "trace": 1, "transpose": 1,
             "identity": 1, "rotation": 1}


def need(condition, what):
    if not condition:
        raise Fault(f"the model: {what}")


class Scalar:
    """A fraction: a numerator over a product of powers of divisors, {number of a divisor: power}."""

    def __init__(self, of, numerator, denominator, is_constant=False):
        self.of, self.numerator, self.denominator = of, numerator, denominator
        self.is_constant = is_constant  # contains neither data nor unknowns
        of.spend()

    def over(self, denominator):
        """The numerator over a multiple of the denominator."""
        result = self.numerator
        for divisor, power in denominator.items():
            for _ in range(power - self.denominator.get(divisor, 0)):
                result = result * self.of.divisors[divisor]
        return result

    def __add__(self, other):
        other = self.of.scalar(other)
        common = {d: max(self.denominator.get(d, 0), other.denominator.get(d, 0))
                  for d in {*self.denominator, *other.denominator}}
        return Scalar(self.of, self.over(common) + other.over(common), common,
                      self.is_constant and other.is_constant)

    def __mul__(self, other):
        other = self.of.scalar(other)
        powers = {d: self.denominator.get(d, 0) + other.denominator.get(d, 0)
                  for d in {*self.denominator, *other.denominator}}
        return Scalar(self.of, self.numerator * other.numerator, powers,
                      self.is_constant and other.is_constant)

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self):
        return self * -1

    def __sub__(self, other):
        return self + other * -1

    def __rsub__(self, other):
        return self * -1 + other

    def inverse(self):
        """A division, if it is no constant."""
        if self.is_constant:
            return Scalar(self.of, self.of.ring.inverse(self.numerator), {}, True)
        one = Scalar(self.of, self.of.ring.constant(1), {})
        self.of.divisors.append(self.numerator)
        return Scalar(self.of, one.over(self.denominator), {len(self.of.divisors) - 1: 1})


def shape(value):
    return (len(value), *shape(value[0])) if isinstance(value, list) else ()


def scalars(value):
    return [s for item in value for s in scalars(item)] if isinstance(value, list) else [value]


def each(function, *values):
    """The function of the scalars at each place."""
    if isinstance(values[0], list):
        return [each(function, *items) for items in zip(*values)]
    return function(*values)


def transposed(matrix):
    return [list(column) for column in zip(*matrix)]


def product(a, b):
    if not shape(a) or not shape(b):
        factor, array = (b, a) if shape(a) else (a, b)
        return each(lambda x: x * factor, array)
    need(len(shape(a)) == 2 and len(shape(b)) in (1, 2) and shape(a)[1] == shape(b)[0], "a product")
    if len(shape(b)) == 1:
        return apply(a, b)
    return transposed([apply(a, column) for column in transposed(b)])


def determinant(matrix):
    """By its first row."""
    if len(matrix) == 1:
        return matrix[0][0]
    minors = (determinant([row[:k] + row[k + 1:] for row in matrix[1:]]) for k in range(len(matrix)))
    return sum(x * minor * (-1) ** k for k, (x, minor) in enumerate(zip(matrix[0], minors)))


class Execution:
    """What a model says over a ring. `given` has the elements of data, unknowns and other names."""

    def __init__(self, model, ring, given):
        self.ring, self.given = ring, given
        self.operations, self.executed = 0, 0
        self.divisors, self.conditions, self.equations, self.relations, self.counted = [], [], [], [], []
        self.values, self.loops = {}, {}
        self.execute_all(model["statement"])

    def spend(self):
        self.operations += 1
        need(self.operations <= 5_000_000, "too many operations")

    def scalar(self, number):
        return number if isinstance(number, Scalar) else Scalar(self, self.ring.constant(number), {}, True)

    # Statements.

    def execute_all(self, statements):
        for statement in statements:
            self.executed += 1
            need(self.executed <= 100_000 and len(self.equations) <= 1000, "too many statements")
            self.execute(statement["words"][0], statement)

    def execute(self, kind, node):
        if kind in ("data", "unknown"):
            need(not self.loops, "data or unknowns in a loop")
            for variable in node["variable"]:
                self.define(variable["NAME"][0], self.given_value(variable["NAME"][0], variable["SIZE"]))
            return
        if kind == "for":
            self.repeat(node)
            return
        values = [self.sum(part) for part in node["sum"]]
        if kind == "let":
            name, = node["NAME"]
            is_given = name in self.given and not self.loops
            self.define(name, self.given_value(name, shape(values[0])) if is_given else values[0])
        elif kind == "count":
            self.counted += scalars(values)
        elif kind == "nonzero":
            self.conditions += [x.numerator for x in scalars(values)]
        elif node["words"][1] == "~":
            self.proportional(*values)
        else:
            need(shape(values[0]) == shape(values[1]), "shapes of an equation")
            rows = self.equations if kind == "equation" else self.relations
            rows += [x.numerator for x in scalars(each(lambda a, b: a - b, *values))]

    def given_value(self, name, sizes):
        items = [Scalar(self, x, {}) for x in self.given[name]]
        for size in reversed(sizes):
            items = [items[i:i + size] for i in range(0, len(items), size)]
        return items[0]

    def define(self, name, value):
        need(name not in RESERVED and name not in FUNCTIONS, f"the name {name}")
        need(name not in self.values and name not in self.loops, f"{name} twice")
        self.values[name] = value

    def proportional(self, u, v):
        need(len(shape(u)) == 1 and shape(u) == shape(v) and len(u) > 1, "`~`")
        self.equations += [(x * v[-1] - u[-1] * y).numerator for x, y in zip(u[:-1], v[:-1])]
        self.conditions += [u[-1].numerator, v[-1].numerator]

    def repeat(self, node):
        name, = node["NAME"]
        self.define(name, None)
        del self.values[name]
        first, last = (self.index(node) for node in node["index"])
        for i in range(first, last + 1 if node["statement"] else first):
            self.loops[name] = i
            self.execute_all(node["statement"])
            for inner in node["statement"]:
                if inner["words"][0] == "let":
                    self.values.pop(inner["NAME"][0])
        self.loops.pop(name, None)

    # Expressions.

    def index(self, node):
        total, signs = 0, ["+", *node["words"]]
        for sign, item in zip(signs, node["number"]):
            number, = item["CONSTANT"] or item["NAME"]
            if isinstance(number, str):
                need(number in self.loops, f"{number} is no loop")
                number = self.loops[number]
            total += -number if sign == "-" else number
        need(abs(total) <= 10**6, "an index")
        return total

    def sum(self, node):
        signs = node["words"] if len(node["words"]) == len(node["product"]) else ["+", *node["words"]]
        terms = (self.product(part) for part in node["product"])
        total = None
        for sign, term in zip(signs, terms):
            term = each(lambda x: -x, term) if sign == "-" else term
            need(total is None or shape(total) == shape(term), "shapes of a sum")
            total = term if total is None else each(lambda a, b: a + b, total, term)
        return total

    def product(self, node):
        result = self.power(node["power"][0])
        for sign, part in zip(node["words"], node["power"][1:]):
            factor = self.power(part)
            result = product(result, factor) if sign == "*" else self.quotient(result, factor)
        return result

    def quotient(self, array, divisor):
        need(not shape(divisor), "a divisor")
        if not divisor.is_constant:
            self.conditions.append(divisor.numerator)
        inverse = divisor.inverse()
        return each(lambda x: x * inverse, array)

    def power(self, node):
        base = result = self.atom(node["atom"][0])
        need(not node["POWER"] or not shape(base), "a power")
        for _ in range(1, (node["POWER"] or [1])[0]):
            result = result * base
        return result

    def atom(self, node):
        value = self.simple(node)
        for index in node["index"]:
            place = self.index(index)
            need(shape(value) and 1 <= place <= len(value), "an item")
            value = value[place - 1]
        return value

    def simple(self, node):
        if node["CONSTANT"]:
            return self.scalar(node["CONSTANT"][0])
        if not node["NAME"]:
            values = [self.sum(part) for part in node["sum"]]
            if node["words"][0] == "(":
                return values[0]
            need(len({shape(value) for value in values}) == 1, "the items of a list")
            return values
        name, = node["NAME"]
        if node["sum"]:
            return self.call(name, node["sum"])
        need(name in self.loops or name in self.values, f"{name} has no meaning")
        return self.scalar(self.loops[name]) if name in self.loops else self.values[name]

    def call(self, name, parts):
        need(len(parts) == FUNCTIONS.get(name), f"the function {name}")
        if name == "identity":
            size = constant_of(parts[0])
            need(size is not None and 1 <= size <= 100, "identity")
            return [[self.scalar(int(i == j)) for j in range(size)] for i in range(size)]
        a, *rest = [self.sum(part) for part in parts]
        shapes = [shape(a), *map(shape, rest)]
        if name in ("dot", "norm2"):
            need(len(shapes[0]) == 1 and len(set(shapes)) == 1, "vectors")
            return dot(a, rest[0] if rest else a)
        if name in ("cross", "skew"):
            need(set(shapes) == {(3,)}, "vectors of three")
            return cross(a, *rest) if rest else self.skew(*a)
        if name == "rotation":
            need(shapes[0] in ((3,), (4,)), "a quaternion")
            q = [self.scalar(1)] * (4 - len(a)) + a
            self.conditions.append(dot(q, q).numerator)
            return quaternion_matrix(*q)
        need(len(shapes[0]) == 2, "a matrix")
        if name == "transpose":
            return transposed(a)
        need(shapes[0][0] == shapes[0][1] and (name == "trace" or len(a) <= 6), "a square matrix")
        return sum(a[i][i] for i in range(len(a))) if name == "trace" else determinant(a)

    def skew(self, x, y, z):
        zero = self.scalar(0)
        return [[zero, -z, y], [z, zero, -x], [-y, x, zero]]


def constant_of(node):
    """Of a sum that is just a CONSTANT."""
    while len(node.get("product", node.get("power", node.get("atom", [])))) == 1:
        if node.get("words") or node.get("POWER"):
            return None
        node, = node.get("product") or node.get("power") or node.get("atom")
    return node["CONSTANT"][0] if node["CONSTANT"] and not node["index"] else None


def depth_of(node):
    """How many sums and loops stand in each other."""
    deepest = 0
    for name, parts in node.items():
        for part in parts:
            if isinstance(part, dict):
                own = name == "sum" or name == "statement" and part["words"][0] == "for"
                deepest = max(deepest, own + depth_of(part))
    return deepest
