"""Section 16, fibres: polynomials modulo q, and numbers modulo q and a polynomial g."""

import itertools

from grammar import Q, require

SLOT = 17  # bytes that hold a sum of 2^14 products of residues


def trimmed(a):
    a = [x % Q for x in a]
    while a and not a[-1]:
        a.pop()
    return a


def packed(a):
    return int.from_bytes(b"".join(x.to_bytes(SLOT, "little") for x in a), "little")


def product(a, b):
    """By one product of integers: the polynomials at a large power of two."""
    if not a or not b:
        return []
    size = len(a) + len(b) - 1
    data = (packed(a) * packed(b)).to_bytes(SLOT * size, "little")
    return [int.from_bytes(data[i:i + SLOT], "little") % Q for i in range(0, SLOT * size, SLOT)]


def division(a, b):
    """(quotient, remainder) of trimmed polynomials."""
    a, inverse = list(a), pow(b[-1], -1, Q)
    quotient = [0] * max(0, len(a) - len(b) + 1)
    while len(a) >= len(b):
        shift, factor = len(a) - len(b), a[-1] * inverse % Q
        quotient[shift] = factor
        a[shift:] = [(x - factor * y) % Q for x, y in zip(a[shift:], b)]
        a = trimmed(a)
    return quotient, a


def common_divisor(a, b):
    a, b = trimmed(a), trimmed(b)
    while b:
        a, b = b, division(a, b)[1]
    return a


class Ring:
    """F_q[t] / (g), g monic."""

    def __init__(self, g):
        self.g, self.size = g, len(g) - 1
        # The power series of one by g, its coefficients reversed.
        reverse, self.series = g[::-1], [1]
        for k in range(1, self.size):
            self.series.append(-sum(reverse[i] * self.series[k - i] for i in range(1, k + 1)) % Q)

    def number(self, coefficients):
        return Number(self, (list(coefficients) + [0] * self.size)[:self.size])

    def variable(self):
        return self.number([-self.g[0] % Q] if self.size == 1 else [0, 1])

    def reduced(self, a):
        high = max(0, len(a) - self.size)
        quotient = product(a[::-1][:high], self.series[:high])[:high][::-1]
        multiple = product(quotient, self.g[:-1])
        multiple += [0] * self.size
        return [(x - y) % Q for x, y in zip(a + [0] * self.size, multiple[:self.size])]

    def has_common_root(self, *numbers):
        """Whether some root of g is one of all these numbers, which may be integers."""
        common = self.g
        for number in numbers:
            common = common_divisor(common, number.c if isinstance(number, Number) else [number])
        return len(common) != 1


class Number:
    """An element of a ring; integers are elements, too."""

    def __init__(self, ring, coefficients):
        self.ring, self.c = ring, coefficients

    def __add__(self, other):
        other = other.c if isinstance(other, Number) else self.ring.number([other]).c
        return Number(self.ring, [(x + y) % Q for x, y in zip(self.c, other)])

    def __mul__(self, other):
        if isinstance(other, Number):
            return Number(self.ring, self.ring.reduced(product(self.c, other.c)))
        return Number(self.ring, [x * other % Q for x in self.c])

    __radd__, __rmul__ = __add__, __mul__

    def __sub__(self, other):
        return self + other * -1

    def __rsub__(self, other):
        return self * -1 + other

    def is_zero(self):
        return not any(self.c)

    def inverse(self):
        """None if it has a common root with g."""
        r, s, r1, s1 = self.ring.g, [], trimmed(self.c), [1]
        while r1:
            quotient, rest = division(r, r1)
            step = product(quotient, s1)
            size = max(len(step), len(s))
            step, s = step + [0] * (size - len(step)), s + [0] * (size - len(s))
            r, r1, s, s1 = r1, rest, s1, trimmed(x - y for x, y in zip(s, step))
        if len(r) != 1:
            return None
        return self.ring.number([x * pow(r[0], -1, Q) % Q for x in s])


def is_regular(ring, rows):
    """Whether the determinant has no root in common with g, by pivots that have none, either."""
    for column in range(len(rows)):
        inverses = ((i, rows[i][column].inverse()) for i in range(column, len(rows)))
        place, inverse = next(((i, x) for i, x in inverses if x), (None, None))
        if inverse is None:
            return False
        rows[column], rows[place] = rows[place], rows[column]
        for row in rows[column + 1:]:
            factor = row[column] * inverse
            for k in range(column, len(rows)):
                row[k] = row[k] - factor * rows[column][k]
    return True


def power_of_variable(ring):
    """t^q."""
    result = ring.number([1])
    for bit in bin(Q)[2:]:
        result = result * result
        if bit == "1":
            result = result * ring.variable()
    return result


def cycle_type(g):
    """The degrees of the irreducible factors of g, which has no multiple root, ascending."""
    ring, degrees, rest, n = Ring(g), [], g, 0
    image = power_of_variable(ring)
    images = list(itertools.accumulate(range(1, ring.size), lambda x, _: x * image, initial=ring.number([1])))
    power = ring.variable()  # t^(q^n)
    while len(rest) > 1:
        n += 1
        power = sum((x * factor for x, factor in zip(images, power.c)), ring.number([0]))
        factors = common_divisor(rest, (power - ring.variable()).c)
        degrees += [n] * ((len(factors) - 1) // n)
        rest = division(rest, factors)[0]
    return degrees


def sums_of_parts(numbers):
    sums = {0}
    for number in numbers:
        sums |= {total + number for total in sums}
    return sums


def is_prime(number):
    return number > 1 and all(number % d for d in range(2, number))


def fits(lengths, block):
    """Whether the cycles fit blocks of so many points."""
    def fills(cycle):
        others = list(lengths)
        others.remove(cycle)
        return any(block - cycle // n in sums_of_parts([other // n for other in others if other % n == 0])
                   for n in range(1, cycle + 1) if cycle % n == 0)
    return all(map(fills, set(lengths)))


def group_shown(types, degree, one_orbit):
    """What fibres with these cycles certify of the group of so many solutions; None if nothing."""
    if not types or not one_orbit and set.intersection(*map(sums_of_parts, types)) != {0, degree}:
        return None
    blocks = [b for b in range(2, degree) if degree % b == 0]
    alone = [p for lengths in types for p in lengths if is_prime(p) and sum(l % p == 0 for l in lengths) == 1]
    if any(all(fits(lengths, block) for lengths in types) for block in blocks) or \
            not any(p <= 3 or p <= degree - 3 for p in alone) or len(set(map(tuple, types))) < 2:
        return None
    parities = {len(lengths) % 2 for lengths in types}
    return f"S{degree}" if len(parities) == 2 else f">=A{degree}"


def read_fibre(node):
    """(the ring, the unknowns) of the lines of a fibre; require items 1 and the sum of item 2."""
    lines = node["fibre-lines"][0]
    ring = Ring(lines["polynomial"][0]["RESIDUE"] + [1])
    require(len(common_divisor(ring.g, [i * x for i, x in enumerate(ring.g)][1:])) == 1,
            "a multiple root")
    unknowns = [ring.number(line["RESIDUE"]) for line in lines["unknown"]]
    total = sum(x * factor for x, factor in zip(unknowns, lines["INT"]))
    require((total - ring.variable()).is_zero(), "the sum is not t")
    return ring, unknowns
