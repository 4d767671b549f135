"""Section 16: the rings that models are executed over, and elimination of sparse rows."""

import itertools

from fibre import Number
from grammar import Q, require

LARGE = 2**521 - 1  # a prime: a polynomial that is not 0 is not 0 at a random place modulo it


class Large:
    """Integers modulo a large prime."""

    class Element(int):
        def __add__(self, other):
            return Large.Element(int.__add__(self, other) % LARGE)

        def __mul__(self, other):
            return Large.Element(int.__mul__(self, other) % LARGE)

    def constant(self, number):
        return self.Element(number % LARGE)

    def inverse(self, element):
        return self.Element(pow(int(element) or 1, -1, LARGE))


class Tangent:
    """A number of a fibre's ring, or an integer, with its changes {unknown: number}."""

    def __init__(self, value, change):
        self.value, self.change = value, change

    def __add__(self, other):
        change = dict(self.change)
        for k, x in other.change.items():
            change[k] = change[k] + x if k in change else x
        return Tangent(of_ring(self.value + other.value), change)

    def __mul__(self, other):
        change = {}
        for a, b in ((self, other), (other, self)):
            for k, x in a.change.items() if not is_zero(b.value) else ():
                more = of_ring(x * b.value)
                change[k] = change[k] + more if k in change else more
        return Tangent(of_ring(self.value * other.value), change)


def of_ring(number):
    return number if isinstance(number, Number) else number % Q


def is_zero(number):
    return number.is_zero() if isinstance(number, Number) else number % Q == 0


class Constants:
    """Constants modulo q, as `element` makes them of integers."""

    def __init__(self, element):
        self.constant = element

    def inverse(self, element):
        value = element.value
        require(value % Q, "the constant 0 as a divisor")
        return self.constant(pow(value, -1, Q))


class Polynomial:
    """{exponents: residue}, with its degrees, a tuple or None; foreign if an unknown occurs in it that
    is no variable."""

    def __init__(self, terms, degrees, is_foreign=False):
        self.terms, self.degrees, self.is_foreign = terms, degrees, is_foreign

    @property
    def value(self):
        """Of a constant."""
        return next(iter(self.terms.values()), 0)

    def __add__(self, other):
        terms = dict(self.terms)
        for powers, x in other.terms.items():
            terms[powers] = (terms.get(powers, 0) + x) % Q
        degrees = self.degrees or other.degrees
        if self.degrees and other.degrees:
            degrees = tuple(map(max, self.degrees, other.degrees))
        return Polynomial({powers: x for powers, x in terms.items() if x}, degrees,
                          self.is_foreign or other.is_foreign)

    def __mul__(self, other):
        terms = {}
        for (a, x), (b, y) in itertools.product(self.terms.items(), other.terms.items()):
            powers = plus(a, b)
            terms[powers] = (terms.get(powers, 0) + x * y) % Q
        degrees = plus(self.degrees, other.degrees) if self.degrees and other.degrees else None
        return Polynomial({powers: x for powers, x in terms.items() if x}, degrees,
                          self.is_foreign or other.is_foreign)


def plus(a, b):
    return tuple(x + y for x, y in zip(a, b))


def pivots(rows):
    """[(column, entry)] of rows {column: residue} of a matrix, for each its last entry that is not 0
    after elimination by the rows before it; None if rows are dependent."""
    done, found = {}, []
    for row in rows:
        row = {column: x % Q for column, x in row.items() if x % Q}
        while row and (last := max(row)) in done:
            factor = row[last]
            for column, x in done[last].items():
                row[column] = (row.get(column, 0) - factor * x) % Q
                if not row[column]:
                    del row[column]
        if not row:
            return None
        inverse = pow(row[last], -1, Q)
        found.append((last, row[last]))
        done[last] = {column: x * inverse % Q for column, x in row.items()}
    return found


def determinant(rows):
    """Of a square matrix, modulo q."""
    found = pivots(rows)
    if found is None:
        return 0
    result, columns = 1, [column for column, _ in found]
    for i, (_, pivot) in enumerate(found):
        result = result * pivot % Q
        while columns[i] != i:
            place = columns[i]
            columns[i], columns[place] = columns[place], place
            result = -result
    return result % Q
