"""Vectors, elimination, and sums of terms: polynomials, and numbers with their first derivatives."""

from fractions import Fraction

from grammar import Q


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def apply(matrix, vector):
    return [dot(row, vector) for row in matrix]


def quaternion_matrix(a, b, c, d):
    return [[a*a + b*b - c*c - d*d, 2*(b*c - a*d), 2*(b*d + a*c)],
            [2*(b*c + a*d), a*a - b*b + c*c - d*d, 2*(c*d - a*b)],
            [2*(b*d - a*c), 2*(c*d + a*b), a*a - b*b - c*c + d*d]]


class Sum:
    """A sum {key: integer coefficient}; key None is the constant, and `join` multiplies two other
    keys: a list of (key, coefficient)."""

    def __init__(self, terms, join):
        self.terms, self.join = {key: x for key, x in terms.items() if x}, join

    def __add__(self, other):
        terms = dict(self.terms)
        for key, x in (other.terms if isinstance(other, Sum) else {None: other}).items():
            terms[key] = terms.get(key, 0) + x
        return Sum(terms, self.join)

    def __mul__(self, other):
        terms = {}
        for b, y in (other.terms if isinstance(other, Sum) else {None: other}).items():
            for a, x in self.terms.items():
                single = a is None or b is None
                for key, factor in [(b if a is None else a, 1)] if single else self.join(a, b):
                    terms[key] = terms.get(key, 0) + factor * x * y
        return Sum(terms, self.join)

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self):
        return self * -1

    def __sub__(self, other):
        return self + other * -1

    def __rsub__(self, other):
        return self * -1 + other


def eliminate(rows, columns, modulus=None):
    """Eliminates the first `columns` columns, modulo a prime or over the rationals.

    Returns (the product of the pivots with the sign of the exchanges of rows, or 0 if these columns
    are dependent; the other rows without these columns)."""
    rows = [[x % modulus if modulus else Fraction(x) for x in row] for row in rows]
    factor, done = 1, 0
    for column in range(columns):
        pivot = next((i for i in range(done, len(rows)) if rows[i][column]), None)
        if pivot is None:
            factor = 0
            continue
        if pivot != done:
            rows[done], rows[pivot], factor = rows[pivot], rows[done], -factor
        top = rows[done][column:]
        factor *= top[0]
        inverse = pow(top[0], -1, modulus) if modulus else 1 / top[0]
        for row in rows[done + 1:]:
            if row[column]:
                scale = -row[column] * inverse
                if modulus:
                    scale %= modulus
                    row[column:] = [(x + scale * y) % modulus if y else x
                                    for x, y in zip(row[column:], top)]
                else:
                    row[column:] = [x + scale * y for x, y in zip(row[column:], top)]
        factor = factor % modulus if modulus else factor
        done += 1
    return factor, [row[columns:] for row in rows[done:]]


def determinant(rows):
    """Modulo q; the matrix has to be square."""
    return eliminate(rows, len(rows), Q)[0]
