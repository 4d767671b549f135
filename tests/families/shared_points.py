#!/usr/bin/python3
"""Degrees in three views by Theorem W (proofs/shared_points.md): two of the views share as many points as fix their
relative pose and one common focal length.

    shared_points.py CERTS           compares those of certs/three-views-in-part.csv with the theorem
    shared_points.py CERTS KIND      prints a line for each constraint class of the kind

One of these points less, and cameras without that focal length: the degree is that of the smaller problem, times the
ratio of the numbers of relative poses. The smaller degrees are in certs/degrees.csv, by the authors' numbers, or in the
table itself. Nothing is shared with plprove or plcheck. Status 1 if a line is wrong or missing.
"""
import collections
import csv
import fractions
import itertools
import pathlib
import sys

import three_views
import three_views_degrees

# The kind, how many points two views share, the kind without a focal length, and the numbers of relative poses.
LAWS = {"shared-focal": (6, "calibrated", fractions.Fraction(30, 20)),
        "upright-shared-focal": (4, "upright", fractions.Fraction(5, 4))}
SOURCE = "by Theorem W"


def rows_of(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def expanded(problem):
    """The features, each as often as it occurs."""
    terms = [term.rpartition("*") for term in problem.partition(": ")[2].split(" + ")]
    return [feature for count, _, feature in terms for _ in range(int(count or 1))]


def shared_points(features, pair):
    return [feature for feature in features if all("P" in feature.split("/")[view] for view in pair)]


def less(feature, pair):
    """The feature that says one condition less of the pair and no less of the third camera: "" for none at all; nothing
    if there is no such feature."""
    seen = feature.split("/")
    third = 3 - sum(pair)
    if seen[third] == "-":
        return ""
    for view in pair:
        if seen[third] == "a" and seen[view] == "Pa" and seen[3 - third - view] == "P":
            return "/".join("a" if place == view else what for place, what in enumerate(seen))
    return None


def smaller(problem, number):
    """The features of the smaller problem; nothing if no pair of views shares so many points."""
    features = expanded(problem)
    for pair in itertools.combinations(range(3), 2):
        shared = shared_points(features, pair)
        if len(shared) != number:
            continue
        for feature in sorted(shared, key=lambda feature: less(feature, pair) != ""):
            if (rest := less(feature, pair)) is not None:
                features.remove(feature)
                return features + [rest] * (rest != "")
    return None


class Classes:
    """The constraint classes of a kind: a key for each problem."""

    def __init__(self, kind):
        self.kind, parameters = kind, three_views.PARAMETERS[kind]
        self.features = three_views.features_of(parameters)
        self.permutations = three_views.permutations_of(self.features)
        self.pairs = three_views_degrees.pairs_of(self.features)

    def key(self, features):
        counts = collections.Counter(features)
        signature = [counts[feature] for feature in self.features]
        assert sum(signature) == len(features)
        return three_views_degrees.merged(signature, self.pairs, self.permutations)


def known_degrees(certs, kind, classes):
    """By the key of the constraint class."""
    if kind == "calibrated":
        numbers = {int(row["number"]): int(row["degree"]) for row in rows_of(certs / "degrees.csv")}
        problems = enumerate(three_views.problems_of(kind))
        return {classes.key(expanded(problem)): numbers[number] for number, problem in problems if number in numbers}
    return {classes.key(expanded(row["problem"])): int(row["degree"])
            for row in rows_of(certs / "three-views-in-part.csv") if row["problem"].startswith(kind + ":")}


def degrees_by_theorem(certs, kind, problems):
    """The degree of each problem of which the theorem speaks: 0 if it is not minimal."""
    number, without, ratio = LAWS[kind]
    classes = Classes(without)
    known = known_degrees(certs, without, classes)
    for problem in problems:
        if (features := smaller(problem, number)) is not None:
            degree = ratio * known.get(classes.key(features), 0)
            assert degree.denominator == 1
            yield problem, int(degree)


def main():
    certs = pathlib.Path(sys.argv[1])
    if len(sys.argv) > 2:
        counts = dict(three_views_degrees.constraint_classes(sys.argv[2]))
        for problem, degree in degrees_by_theorem(certs, sys.argv[2], counts):
            print(f"{problem},{counts[problem]},{degree},{SOURCE}")
        return
    table = rows_of(certs / "three-views-in-part.csv")
    wrong = 0
    for kind in LAWS:
        known = {row["problem"]: int(row["degree"]) for row in table if row["problem"].startswith(kind + ":")}
        found = dict(degrees_by_theorem(certs, kind, known))
        differ = [problem for problem, degree in found.items() if degree != known[problem]]
        print(f"{kind}: {len(found)} degrees by Theorem W, {len(differ)} of them differ from those on file")
        wrong += len(differ) + (not found)
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()
