#!/usr/bin/python3
"""The integral of Theorem C a second time, from the pages of the proof alone.

    theorem_c.py PLCHECK CERTS [EVERY]

computes the degrees of all constraint classes whose points have at most three pins (or the first of
each EVERY), modulo p = 2^31 - 1. It compares them with what plcheck computes from the
classification in the folder CERTS, and with what certificates show (degrees/lower-bounds.txt there).
Other classes are not minimal: 0 is due. Numbers are less than p.

It shares nothing with checker/: the third blow-up needs no list of fixed points, as Lemma C2 gives
the push-forwards of powers of Gamma as classes, polynomials in the weights at each fixed point.
"""

import json
import re
import subprocess
import sys
from itertools import permutations, product
from math import prod

import numpy as np

from features import CLASSES, EXCHANGES, FEATURES, PAIRS, SWAPS, TABLE, largest_form

P = 2**31 - 1
PLUS, LESS = np.uint64(1), np.uint64(P - 1)
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
    places, columns = range(1, 13), []
    at_zero = [prod(s * inverse(s - t) for s in places if s != t) for t in places]
    for weights, h, square, others, e, strict, x in first_blow_up():
        d = [h[v] - e[v] for v in range(3)]
        equal = len({d[v] for v in strict}) < len(strict)
        for t, factor in zip(places, at_zero) if equal else [(0, 1)]:
            moved = [d[v] + t * SHIFTS[v] for v in range(3)]
            for order_factor, g in orders(strict, moved):
                tilde = [n - e[v] for v in range(3) for n in others[v]]
                columns.append([factor * order_factor * inverse(prod(weights)), *h, *square, *tilde,
                                *e, *x, *(g.get(pair, 0) for pair in PAIRS)])
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
    zero = np.zeros_like((numerators + denominators)[0])
    terms = [zero + PLUS] + [zero] * top
    for a in numerators:
        terms = [terms[0]] + [(terms[i] + times(terms[i - 1], a)) % P for i in range(1, top + 1)]
    for b in denominators:
        for i in range(1, top + 1):
            terms[i] = minus(terms[i], times(terms[i - 1], b))
    return terms


class Space:
    """The numbers of `nodes`, the push-forwards of the powers of each Gamma, and the classes of the
    features. A class is linear in each Gamma: {None: the part without one, pair: its factor}."""

    def __init__(self):
        base = nodes()
        self.factor, self.h, self.square = base[0], base[1:4], base[4:7]
        self.tilde, self.e = base[7:13].reshape(3, 2, -1), base[13:16]
        self.x, self.g = base[16:20], base[20:23]
        self.zero = np.zeros_like(self.factor)
        self.pushed = [self.push_forward(pair) for pair in range(3)]
        self.classes = [self.feature(*feature) for feature in FEATURES]

    def push_forward(self, pair):
        """What becomes of the powers 0, 1, ... of a Gamma, by Lemma C2."""
        plus = [minus(t, self.x[3]) for v in PAIRS[pair] for t in (self.square[v], *self.tilde[v])]
        plus.append(minus(self.zero, self.x[3]))
        less = [minus(t, self.x[3]) for t in (*self.x, self.g[pair])]
        chern, segre = series(plus, less, 3)[3], series(less, plus, 8)
        powers = [times(s, chern) for s in segre]
        return [self.zero + PLUS, self.zero, self.zero] + [
            minus(self.zero, power) if i % 2 else power for i, power in enumerate(powers)]

    def seen(self, views):
        """The factors c + s x, as (c, s), of the S_v(x). As x_v is kappa kappa', the weights of
        W~_v / x_v(-E_v) are the other two."""
        return [(c, LESS) for v in views for c in (self.square[v], self.tilde[v][1])]

    def pin(self, lines, points):
        """Those of Lambda(x) of a line that the views `lines` see, and its point `points`."""
        third = minus(self.h.sum(axis=0) % P, self.x.sum(axis=0) % P)
        return [(self.h[v], LESS) for v in lines - points] + [(third, PLUS)] * (len(lines) == 3)

    def at(self, x, factors):
        return times(self.zero + PLUS, *((c + times(s, x)) % P for c, s in factors))

    def point(self, points, pins):
        """<f> of a point that the views `points` see; `pins` are the sets of views of its lines."""
        of_pins = [factor for lines in pins for factor in self.pin(lines, points)]
        polynomial = [self.zero + PLUS]
        for c, s in self.seen(points) + of_pins:
            polynomial = [(times(a, c) + times(b, s)) % P
                          for a, b in zip(polynomial + [self.zero], [self.zero] + polynomial)]
        # The integral over P(V) takes x^n to minus the complete symmetric polynomial of degree n-3.
        complete = series([], [minus(self.zero, x) for x in self.x], len(polynomial))
        result = {None: self.zero}
        for a, symmetric in zip(polynomial[3:], complete):
            result[None] = minus(result[None], times(a, symmetric))
        for pair, (u, v) in enumerate(PAIRS):
            if {u, v} <= points:
                rest, g = self.seen(points - {u, v}) + of_pins, self.g[pair]
                result[None] = minus(result[None], times(g, self.at(self.zero, rest)))
                result[pair] = minus(self.zero, self.at(minus(self.x[3], g), rest))
        return result

    def missed(self, view):
        """F_v."""
        return times(self.e[view], minus(self.h[view], self.square[view]))

    def free_line(self):
        _, c1, c2 = series([*self.h], [*self.x], 2)
        missed = sum(map(self.missed, range(3))) % P
        return {None: minus(minus(times(c1, c1), c2), missed)}

    def feature(self, point, lines):
        """The class of one of the 27 features, as Lemma C6 says."""
        if point is None:
            return self.free_line()
        total = self.point(point, lines)
        if len(point) == 2 and lines and len(lines[0]) == 3:
            missed = self.missed(*{0, 1, 2} - point)
            for pair, value in self.point(point, ()).items():
                total[pair] = minus(total[pair], times(missed, value))
        return total

    def integral(self, signature):
        factors = [self.classes[i] for i, n in enumerate(signature) for _ in range(n)]
        left = [sum(pair in factor for factor in factors) for pair in range(3)]
        found = {(0, 0, 0): self.factor}  # for the powers of the three Gamma
        for factor in factors:
            left = [n - (pair in factor) for pair, n in enumerate(left)]
            terms, found = found, {}
            for powers, value in terms.items():
                for pair, of_pair in factor.items():
                    raised = tuple(n + (i == pair) for i, n in enumerate(powers))
                    if counts(raised, left):
                        found[raised] = (found.get(raised, self.zero) + times(value, of_pair)) % P
        return sum(int(times(value, *(self.pushed[i][n] for i, n in enumerate(powers))).sum())
                   for powers, value in found.items()) % P


def counts(powers, left):
    """Whether a product with these powers of the Gamma, times at most `left` more, can be not 0: no
    point is in all three C_uv, and the push-forwards of a Gamma and its square are 0."""
    return 0 in powers and all(n == 0 or n + more >= 3 for n, more in zip(powers, left))


def main(plcheck, certs, every=1):
    constraint_classes = [largest_form(s, SWAPS + EXCHANGES) for s in CLASSES.all()]
    report = subprocess.run([plcheck, "--table", "--json", f"{certs}/classification.plc"],
                            capture_output=True, text=True).stdout
    certified = re.findall(r"class (\d+): certified to have at least (\d+)",
                           open(f"{certs}/degrees/lower-bounds.txt").read())
    due = [{constraint_classes[int(number)]: int(degree) for number, degree in numbers}
           for numbers in (certified, json.loads(report)["certified_exactly"])]
    classes = [s for s in sorted(set(constraint_classes)) if not any(s[:4])][::every]
    space, wrong = Space(), 0
    for signature in classes:
        found, degrees = space.integral(signature), [known.get(signature, 0) for known in due]
        if degrees != [found, found]:
            wrong += 1
            names = " + ".join(f"{n}*{name}" for n, name in zip(signature, TABLE) if n)
            print(f"{names}: {found}, not {degrees}", file=sys.stderr)
    print(f"{len(classes)} constraint classes: {wrong} numbers differ from those due")
    return wrong > 0


sys.exit(main(*sys.argv[1:3], *map(int, sys.argv[3:4])))
