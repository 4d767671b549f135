#!/usr/bin/python3
"""Three views that may each miss points and lines, as in the paper, with cameras that are calibrated in
part: lists all label classes of balanced problems of the 27 features (certs/FORMAT.md, section 1),
and of points with more pins, has plprove certify each, and plcheck replay that.

    three_views.py PLPROVE PLCHECK [KIND...]       upright and upright-shared-focal, if none is named

Prints a line for each kind. The number of classes is counted a second time, by Burnside's lemma; those that
are minimal are as many as those whose degree is not 0 (certs/three-views-in-part.csv). Status 1 if one has
no certificate, or the numbers differ.
"""
import collections
import itertools
import pathlib
import re
import subprocess
import sys
import tempfile

CERTS = pathlib.Path(__file__).resolve().parents[2] / "certs"
PAGE, DEGREES = CERTS / "FORMAT.md", CERTS / "three-views-in-part.csv"
TABLE = [name for _, name in sorted((int(index), name) for index, name in re.findall(
    r"\| (\d+) \| `(\S+)`", PAGE.read_text()))]
# How many parameters three cameras have, up to motions of space: what weights add up to.
PARAMETERS = {"upright": 7, "upright-shared-focal": 8, "upright-focal": 10, "calibrated": 11, "shared-focal": 12}
MOST_IN_A_FILE = 100_000
ORDERS = list(itertools.permutations(range(3)))


def weight(feature):
    """Degrees of freedom in the images less those in space."""
    views = feature.split("/")
    pins = {letter for seen in views for letter in seen if letter.islower()}
    is_point = len(pins) != 1 or "P" in feature
    in_space = 3 + 2 * len(pins) if is_point else 4
    return sum(1 + len(seen) if "P" in seen else 2 * len(seen.strip("-")) for seen in views) - in_space


def relabeled(feature, order):
    """The feature with its views in another order, and its pins named anew."""
    views = [feature.split("/")[view] for view in order]
    pins = sorted({letter for seen in views for letter in seen if letter.islower()},
                  key=lambda pin: [pin not in seen for seen in views])
    names = dict(zip(pins, "abcdefghi"))
    return "/".join("".join(sorted(names.get(letter, letter) for letter in seen)) for seen in views)


def features_of(parameters):
    """The 27, as far as their weights allow; with 12 parameters also points with eight or nine pins that all views
    see. (The paper's list for 11 has none with eight.)"""
    stars = ["/".join(3 * ["P" + "abcdefghi"[:pins]]) for pins in (9, 8) if parameters == 12]
    return [feature for feature in stars + TABLE if weight(feature) <= parameters]


def permutations_of(features):
    """For each order of the views, where each feature goes."""
    index = {relabeled(feature, (0, 1, 2)): i for i, feature in enumerate(features)}
    return [[index[relabeled(feature, order)] for feature in features] for order in ORDERS]


def signatures(weights, left):
    """All vectors of multiplicities whose weights add up, in decreasing lexicographic order."""
    if not weights:
        if left == 0:
            yield ()
        return
    for count in range(left // weights[0], -1, -1):
        for rest in signatures(weights[1:], left - count * weights[0]):
            yield (count, *rest)


def moved(signature, places):
    result = [0] * len(signature)
    for i, count in enumerate(signature):
        result[places[i]] += count
    return tuple(result)


def counted_by_burnside(weights, permutations, parameters):
    """The number of classes: the mean of the numbers of signatures that a permutation keeps."""
    kept = 0
    for places in permutations:
        ways, left = [1] + parameters * [0], set(range(len(weights)))
        while left:
            cycle, i = 0, next(iter(left))
            while i in left:
                left.remove(i)
                cycle, i = cycle + weights[i], places[i]
            for total in range(cycle, parameters + 1):
                ways[total] += ways[total - cycle]
        kept += ways[parameters]
    return kept // len(permutations)


def notation(kind, features, signature):
    return f"{kind}: " + " + ".join(f"{count}*{feature}" if count > 1 else feature
                                    for feature, count in zip(features, signature) if count)


def problems_of(kind):
    """A problem of each label class, as notation."""
    parameters = PARAMETERS[kind]
    features = features_of(parameters)
    weights, permutations = list(map(weight, features)), permutations_of(features)
    found = [signature for signature in signatures(weights, parameters)
             if all(signature >= moved(signature, places) for places in permutations)]
    assert len(found) == counted_by_burnside(weights, permutations, parameters)
    return [notation(kind, features, signature) for signature in found]


def reason(record):
    """Why a record says that its problem is not minimal, in a word or two."""
    found = re.search(r"^motion ((?:projective )?\w+)", record, re.M)
    return found[1] if found else record.split("\n")[1].split()[0]


def decide(plprove, plcheck, problems, folder):
    """The numbers of records by verdict and reason, once plcheck has replayed them."""
    mine, file = folder / "mine.txt", folder / "mine.plc"
    mine.write_text("".join(f"{problem}\n" for problem in problems))
    certified = subprocess.run([plprove, "certify", "--list", mine, "-o", file], check=False)
    checked = subprocess.run([plcheck, "--quiet", "--effort", "100000000", "--expect-list", mine, file],
                             check=False)
    if certified.returncode or checked.returncode:
        sys.exit(1)
    return collections.Counter(map(reason, file.read_text().split("problem ")[1:]))


def label_classes_with_solutions():
    """Their number for each kind, where the degrees of all of its classes are on file."""
    found = collections.Counter()
    for line in DEGREES.read_text().splitlines():
        if ": " in line and not line.startswith("#"):
            problem, count, degree, _ = line.split(",")
            found[problem.partition(":")[0]] += int(count) * (degree != "0")
    del found["shared-focal"]
    return found


def main():
    plprove, plcheck, *kinds = sys.argv[1:]
    with_solutions = label_classes_with_solutions()
    for kind in kinds or ["upright", "upright-shared-focal"]:
        problems, reasons = problems_of(kind), collections.Counter()
        with tempfile.TemporaryDirectory() as folder:
            for first in range(0, len(problems), MOST_IN_A_FILE):
                reasons += decide(plprove, plcheck, problems[first:first + MOST_IN_A_FILE],
                                  pathlib.Path(folder))
        minimal = reasons.pop("minimal", 0)
        others = ", ".join(f"{count} {why}" for why, count in sorted(reasons.items()))
        print(f"{kind}: {len(problems)} label classes, {minimal} minimal; not minimal by {others}",
              flush=True)
        if with_solutions.get(kind, minimal) != minimal:
            sys.exit(f"{with_solutions[kind]} label classes of {kind} have a degree that is not 0")


if __name__ == "__main__":
    main()
