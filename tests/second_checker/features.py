"""Sections 1 and 4: the 27 features, signatures, label classes, obstructions."""

import re
from collections import namedtuple
from itertools import permutations
from operator import itemgetter

from general import Problem, parse
from grammar import PAGE, Fault

# `point` is the set of views that see the point, None for a free line; `lines` has one such set for
# each pin, or for the free line.
Feature = namedtuple("Feature", "point lines")
LETTERS = "abcdefghijklmnopqrstuvwxyz"
# Of the table of section 1, whose columns are pairs of an index and a feature.
TABLE = [name for _, name in sorted((int(index), name) for index, name in re.findall(
    r"\| (\d+) \| `(\S+)`", PAGE.read_text()))]
PAIRS = ((0, 1), (0, 2), (1, 2))


def parse_feature(name):
    """(the feature, its number of views) of a FEATURE of section 1."""
    views, point, letters = parse(name)
    if views > 3 or "".join(letters) != LETTERS[:len(letters)]:
        raise Fault(f"{name}: the names of pins, or the number of views")
    return Feature(point, tuple(letters.values())), views


def unnamed(feature):
    return feature.point, sorted(map(sorted, feature.lines))


FEATURES = [parse_feature(name)[0] for name in TABLE]


def index_of(feature):
    """The index in the table up to the names of pins, or None."""
    return next((i for i, f in enumerate(FEATURES) if unnamed(f) == unnamed(feature)), None)


def problem_of(feature, views=3):
    """The problem that is this feature alone."""
    return Problem([(feature.point, dict(zip(LETTERS, feature.lines)))], views)


def weight(feature):
    """Degrees of freedom in the images less those in space."""
    space, seen = problem_of(feature).dimensions()
    return seen - space


def relabeled(feature, order):
    point, *lines = (None if views is None else frozenset(order[v] for v in views)
                     for views in (feature.point, *feature.lines))
    return Feature(point, tuple(lines))


WEIGHTS = [weight(f) for f in FEATURES]
# For each permutation of the views, where each index comes from.
RELABELINGS = [[index_of(relabeled(f, order)) for f in FEATURES] for order in permutations(range(3))]
RELABEL = [itemgetter(*order) for order in RELABELINGS]


def representative(signature):
    return max(relabel(signature) for relabel in RELABEL)


SWAPS, EXCHANGES = ((12, 13), (14, 15), (16, 17)), ((21, 24), (22, 25), (23, 26))


def largest_form(signature, pairs):
    """The largest signature that relabelings and the exchange of the features of pairs lead to."""
    forms = []
    for order in RELABELINGS:
        form = [signature[i] for i in order]
        for first, second in pairs:
            form[first], form[second] = form[first] + form[second], 0
        forms.append(form)
    return tuple(max(forms))


def balanced_signatures():
    """In decreasing lexicographic order."""
    found = []

    def extend(prefix, left):
        if len(prefix) == 27:
            if left == 0:
                found.append(prefix)
            return
        step = WEIGHTS[len(prefix)]
        for count in range(left // step, -1, -1):
            extend((*prefix, count), left - count * step)

    extend((), 11)
    return found


class Classes:
    """The label classes in the order of their numbers, enumerated when they are needed."""

    def __init__(self):
        self.found, self.signatures = [], 0

    def all(self):
        if not self.found:
            signatures = balanced_signatures()
            self.signatures = len(signatures)
            self.found = [s for s in signatures if representative(s) == s]
            self.numbers = {s: number for number, s in enumerate(self.found)}
        return self.found

    def number(self, signature):
        self.all()
        return self.numbers[representative(signature)]


CLASSES = Classes()


def obstruction(features):
    """(excess of the pairs 12, 13, 23; S) of features of the table."""
    excess = [max(0, sum({i, j} <= (f.point or set()) for f in features) - 5) for i, j in PAIRS]
    for star in features:
        pins = len(star.lines)
        if star.point == {0, 1, 2} and pins >= 3:
            others = list(features)
            others.remove(star)
            blind = any(all(v not in views for f in others for views in (f.point or (), *f.lines))
                        for v in range(3))
            if pins == 7 or blind or pins == 6 and any(f.point is None for f in others):
                return excess, 1
    return excess, 0
