#!/usr/bin/python3
"""The integral of Theorem C a second time, from the pages of the proof alone.

    theorem_c.py LOWER_BOUNDS [EVERY]

computes the degrees of all constraint classes whose points have at most three pins (or the first of
each so many), modulo p = 2^31 - 1, and compares them with what certificates show: certs/degrees/
lower-bounds.txt. Classes that are not on file are not minimal: 0 is due. Numbers are less than p.

It shares nothing with checker/: the third blow-up needs no list of fixed points, as Lemma C2 gives
the push-forwards of powers of Gamma as classes, polynomials in the weights at each fixed point.
"""

import re
import sys
from itertools import combinations, permutations, product

import numpy as np

from features import CLASSES, RELABELINGS, TABLE

P = 2**31 - 1
PAIRS = ((0, 1), (0, 2), (1, 2))
Y = (1203457, 94821713, 1740261223)  # the weights of the tori: any that are general
SHIFTS = (7, 1001, 92357)  # directions in which equal classes d_v are moved apart


def inverse(x):
    return pow(x % P, -1, P)


def fixed_points_of_m():
    """(tangent weights, h, kappa^2, the other two of each W_v, null views, weights of V) on M.

    The last weight of V is that of V/H. Section *How to integrate*: three null views, or two."""
    points = []
    for signs in product((1, -1), repeat=3):
        h = [-2 * e * y for e, y in zip(signs, Y)]
        points.append(([t for x in h for t in (x, x)], h, [0, 0, 0], [(x, 2 * x) for x in h],
                       {0, 1, 2}, [0, 0, 0], [(v, t) for v in range(3) for t in (h[v], 2 * h[v])]))
    for w, e_u, e_v, sigma in product(range(3), (1, -1), (1, -1), (1, -1)):
        z, views = Y[w], [v for v in range(3) if v != w]
        h, square, others, tangents, quotient = [0] * 3, [2 * z] * 3, [(0, -2 * z)] * 3, [], []
        for v, e, s in zip(views, (e_u, e_v), (sigma, -sigma)):
            square[v], step = 2 * s * z, 2 * e * Y[v]
            h[v] = square[v] - step
            others[v] = h[v], h[v] - step
            tangents += [-step, square[v], h[v]]
            quotient += [(v, h[v]), (v, h[v] - step)]
        points.append((tangents, h, square, others, set(views), [2 * z, 0, -2 * z],
                       quotient + [(w, 2 * z), (w, -2 * z)]))
    for tangents, h, square, others, null, of_h, quotient in points:
        for i, (view, omega) in enumerate(quotient):
            rest = [t - omega for j, (_, t) in enumerate(quotient) if j != i]
            yield tangents + rest, h, square, others, null, view, of_h + [omega]


def first_blow_up():
    """(tangent weights, h, kappa^2, the other two, the E_v, the views on J~_v, weights of V)."""
    for tangents, h, square, others, null, view, x in fixed_points_of_m():
        inside = [v for v in null if v != view]  # those with the point in Y_v
        normals = {v: [h[v]] + [t - x[3] for t in others[v]] for v in inside}
        for choice in product(range(3), repeat=len(inside)):
            weights, e, strict = list(tangents), [0, 0, 0], set(null)
            for v, chosen in zip(inside, choice):
                e[v] = normals[v][chosen]
                for i, t in enumerate(normals[v]):
                    weights.remove(t)
                    weights.append(t if i == chosen else t - e[v])
                if chosen == 0:
                    strict.remove(v)
            yield weights, h, square, others, e, sorted(strict), x


def orders(strict, d):
    """(factor, {pair: G}) of the second blow-up, for different d."""
    if len(strict) < 2:
        return [(1, {})]
    found = []
    for order in permutations(strict):
        factor, g = 1, {}
        for k, (i, j) in enumerate(zip(order, order[1:])):
            factor = factor * d[j] * inverse(d[j] - d[i]) % P
            for later in order[k + 1:]:
                g[tuple(sorted((i, later)))] = d[i]
        found.append((factor, g))
    return found


def nodes():
    """Columns of numbers at each fixed point of the second blow-up: factor, h, kappa^2, the other
    two weights of W~_v, the weight of kappa'^2 there again, E, x and G."""
    # The values are polynomials of degree 11 at most in the d: twelve places give that at 0.
    places, at_zero, columns = range(1, 13), [], []
    for t in places:
        at_zero.append(1)
        for s in places:
            if s != t:
                at_zero[-1] = at_zero[-1] * s * inverse(s - t) % P
    for weights, h, square, others, e, strict, x in first_blow_up():
        euler = 1
        for t in weights:
            euler = euler * t % P
        d = [h[v] - e[v] for v in range(3)]
        equal = len({d[v] for v in strict}) < len(strict)
        for t, factor in zip(places, at_zero) if equal else [(0, 1)]:
            moved = [d[v] + t * SHIFTS[v] for v in range(3)]
            for order_factor, g in orders(strict, moved):
                tilde = [n - e[v] for v in range(3) for n in others[v]]
                columns.append([factor * order_factor * inverse(euler)] + h + square + tilde + e + x
                               + [g.get(pair, 0) for pair in PAIRS])
    return np.array([[n % P for n in column] for column in columns], dtype=np.uint64).T


def times(*factors):
    result = factors[0]
    for factor in factors[1:]:
        result = result * factor % P
    return result


def minus(a, b):
    return (a + P - b) % P


def series(numerators, denominators, top):
    """The terms up to degree top of a product of 1 + a, over one of 1 + b."""
    terms = [np.ones_like(numerators[0])] + [np.zeros_like(numerators[0])] * top
    for a in numerators:
        terms = [terms[0]] + [(terms[i] + times(terms[i - 1], a)) % P for i in range(1, top + 1)]
    for b in denominators:
        for i in range(1, top + 1):
            terms[i] = minus(terms[i], times(terms[i - 1], b))
    return terms


def lagrange(node, degree):
    """The coefficients of the polynomial that is 1 at `node`, and 0 at the others of 0 ... degree."""
    found = [1]
    for other in range(degree + 1):
        if other != node:
            scale = inverse(node - other)
            found = [(a - other * b) * scale % P for a, b in zip([0] + found, found + [0])]
    return found


class Space:
    """The numbers of `nodes`, and for each node of the third blow-up a factor and the Gamma."""

    def __init__(self, base, most, products):
        """`most` bounds the degree in one Gamma; are there products over two pairs of views?"""
        self.unpack(base)
        quadrature = [self.quadrature(i, most) for i in range(3)]
        factors, chosen = [self.factor], [np.arange(self.factor.size)]
        gammas = [np.zeros((3, self.factor.size), dtype=np.uint64)]
        for pairs in [p for n in (1, 2) if most > 2 and n <= 1 + products
                      for p in combinations(range(3), n)]:
            # Products over three pairs are 0: no point is in all three C_uv.
            where = np.nonzero(np.all([quadrature[i].any(axis=0) for i in pairs], axis=0))[0]
            for values in product(range(most + 1), repeat=len(pairs)):
                factor, gamma = self.factor[where], np.zeros((3, where.size), dtype=np.uint64)
                for i, value in zip(pairs, values):
                    factor = times(factor, quadrature[i][value, where])
                    gamma[i] = value
                kept = np.nonzero(factor)[0]
                factors.append(factor[kept])
                chosen.append(where[kept])
                gammas.append(gamma[:, kept])
        self.unpack(base[:, np.concatenate(chosen)])
        self.factor, self.gamma = np.concatenate(factors), np.concatenate(gammas, axis=1)

    def unpack(self, base):
        self.factor, self.h, self.square = base[0], base[1:4], base[4:7]
        self.tilde, self.e = base[7:13].reshape(3, 2, -1), base[13:16]
        self.x, self.g = base[16:20], base[20:23]

    def quadrature(self, pair, most):
        """Factors of the values at Gamma = 0, ..., most: f -> sum of f_i rho^i over i > 0."""
        u, v = PAIRS[pair]
        x4 = self.x[3]
        plus = [minus(t, x4) for w in (u, v) for t in (self.square[w], *self.tilde[w])]
        less = [minus(t, x4) for t in (*self.x, self.g[pair])]
        chern = series(plus + [minus(np.zeros_like(x4), x4)], less, 3)[3]
        segre = series(less, plus + [minus(np.zeros_like(x4), x4)], max(0, most - 3))
        result = np.zeros((most + 1, x4.size), dtype=np.uint64)
        for node in range(most + 1):
            coefficients = lagrange(node, most)
            for i in range(3, most + 1):
                sign = 1 if i % 2 else P - 1
                term = times(segre[i - 3], chern, np.uint64(coefficients[i] * sign % P))
                result[node] = (result[node] + term) % P
        return result

    def seen(self, views):
        """The factors c + s x, as (c, s), of the S_v(x). As x_v is kappa kappa', the weights of
        W~_v / x_v(-E_v) are the other two."""
        return [(c, -1) for v in views for c in (self.square[v], self.tilde[v][1])]

    def pin(self, lines, points):
        """Those of Lambda(x) of a line that the views `lines` see, and its point `points`."""
        third = minus(self.h.sum(axis=0) % P, self.x.sum(axis=0) % P)
        return [(self.h[v], -1) for v in lines - points] + [(third, 1)] * (len(lines) == 3)

    def point(self, points, pins):
        """<f> of a point that the views `points` see; `pins` are the sets of views of its lines."""
        of_pins = [factor for lines in pins for factor in self.pin(lines, points)]
        zero = np.zeros_like(self.factor)
        polynomial = [zero + np.uint64(1)]
        for c, sign in self.seen(points) + of_pins:
            shifted = [zero] + [x if sign > 0 else minus(zero, x) for x in polynomial]
            polynomial = [(times(a, c) + b) % P for a, b in zip(polynomial + [zero], shifted)]
        # The integral over P(V) takes x^n to minus the complete symmetric polynomial of degree n-3.
        complete = series([zero], [minus(zero, x) for x in self.x], max(0, len(polynomial) - 4))
        total = zero
        for n in range(3, len(polynomial)):
            total = minus(total, times(polynomial[n], complete[n - 3]))
        for pair, (u, v) in enumerate(PAIRS):
            if {u, v} <= points:
                rest = self.seen(points - {u, v}) + of_pins
                for scale, x in ((self.g[pair], zero),
                                 (self.gamma[pair], minus(self.x[3], self.g[pair]))):
                    total = minus(total, times(scale, *((c + x) % P if sign > 0 else minus(c, x)
                                                        for c, sign in rest)))
        return total

    def missed(self, view):
        """F_v."""
        return times(self.e[view], minus(self.h[view], self.square[view]))

    def free_line(self):
        c = series(list(self.h), list(self.x), 2)
        total = minus(times(c[1], c[1]), c[2])
        for v in range(3):
            total = minus(total, self.missed(v))
        return total

    def feature(self, name):
        """The class of one of the 27 features, as Lemma C6 says."""
        symbols = name.split("/")
        points = {v for v in range(3) if "P" in symbols[v]}
        if not points:
            return self.free_line()
        letters = sorted(set(name) - set("P/-"))
        pins = [{v for v in range(3) if letter in symbols[v]} for letter in letters]
        total = self.point(points, pins)
        if len(points) == 2 and pins and len(pins[0]) == 3:
            view, = {0, 1, 2} - points
            total = minus(total, times(self.missed(view), self.point(points, [])))
        return total


SAME = {13: 12, 15: 14, 17: 16, 24: 21, 25: 22, 26: 23}


def constraint_class(signature):
    """The largest signature of the class under exchanges, swaps and permutations of the views."""
    collapsed = []
    for order in RELABELINGS:
        collapsed.append([signature[i] for i in order])
        for i, first in SAME.items():
            collapsed[-1][first] += collapsed[-1][i]
            collapsed[-1][i] = 0
    return tuple(max(collapsed))


def needed(signature):
    """(the largest number of points that two views share; whether products over two pairs count).

    By Lemma C2 these need three points of each pair, six in all, as each class is linear."""
    seen = [({v for v in range(3) if "P" in name.split("/")[v]}, count)
            for name, count in zip(TABLE, signature)]
    of_pair = [sum(count for views, count in seen if set(pair) <= views) for pair in PAIRS]
    of_view = [sum(count for views, count in seen if v in views and len(views) > 1)
               for v in range(3)]
    products = any(of_view[v] >= 6 and sum(n >= 3 for pair, n in zip(PAIRS, of_pair) if v in pair) == 2
                   for v in range(3))
    return max(2, *of_pair), products


class Integrals:
    """The classes of the features in one Space, and products of them."""

    def __init__(self, base, *need):
        self.space, self.known = Space(base, *need), {}

    def power(self, index, count):
        if (index, count) not in self.known:
            self.known[index, count] = self.space.feature(TABLE[index]) if count == 1 else \
                times(self.power(index, count - 1), self.power(index, 1))
        return self.known[index, count]

    def of(self, signature):
        factors = [self.power(i, n) for i, n in enumerate(signature) if n]
        return int(times(self.space.factor, *factors).sum()) % P


def main(path, every=1):
    on_file = {constraint_class(CLASSES.all()[int(number)]): int(degree) for number, degree in
               re.findall(r"class (\d+): certified to have at least (\d+)", open(path).read())}
    classes = sorted({constraint_class(s) for s in CLASSES.all()})
    classes = [s for s in classes if not any(s[:4])][::every]
    base, wrong, minimal = nodes(), 0, 0
    for need in sorted(set(map(needed, classes))):
        integrals = Integrals(base, *need)
        for signature in (s for s in classes if needed(s) == need):
            found, due = integrals.of(signature), on_file.get(signature, 0)
            minimal += due > 0
            if found != due:
                wrong += 1
                names = [f"{n}*{name}" for n, name in zip(signature, TABLE) if n]
                print(f"{' + '.join(names)}: {found}, not {due}", file=sys.stderr)
    print(f"{minimal} degrees as on file, {len(classes) - minimal} other classes with the number 0"
          if not wrong else f"{wrong} of {len(classes)} numbers differ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], *map(int, sys.argv[2:3])))
