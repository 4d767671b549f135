"""Section 6: the derived numbers of a classification."""

from features import CLASSES, FEATURES, PAIRS, RELABELINGS, SWAPS, largest_form, obstruction

LISTED = {7, 11, 14, 15, 16, 17, 21}  # on Kileel's list, for view 1


def properties(signature):
    """The letters of section 6 for a class: what its rows count."""
    features = [f for f, count in zip(FEATURES, signature) for _ in range(count)]
    excess, star = obstruction(features)
    found = {letter for letter, holds in zip("ES", (any(excess), star)) if holds}
    for i, j in PAIRS:
        if sum({i, j} <= (f.point or set()) for f in features) == 5:
            found.add("5")
            if all(all((i in line) == (j in line) for line in f.lines) and
                   (f.point is None or (i in f.point) == (j in f.point) or
                    any((j if i in f.point else i) in line for line in f.lines)) for f in features):
                found.add("R")
    most = max((len(f.lines) for f in features if f.point is not None), default=0)
    found |= {"0", "1"} if most == 0 else {"1"} if most == 1 else set()
    if all(i < 8 or i == 11 for i, count in enumerate(signature) if count):
        found.add("C")
    if any(all(not signature[source] or i in LISTED for i, source in enumerate(order))
           for order in RELABELINGS):
        found.add("K")
    if not any(signature[12:18]) and not any(signature[24:27]):
        found.add("A")  # minimal as it stands
    if largest_form(signature, SWAPS) == signature:
        found.add("T")  # stands for its swap class
    return found


# What has to hold, and what must not (after `!`). M is minimal.
ROWS = {"label classes": "", "swap&label classes": "T", "label classes, not minimal": "!M",
        "label classes, minimal": "M", "swap&label classes, not minimal": "T!M",
        "terminal camera-minimal": "TM", "reduced minimal PL0Ps (no pins)": "M0",
        "terminal, at most one pin a point": "TM1", "five-point extensions, minimal": "M5",
        "- of these, camera registration": "MR", "- terminal camera-minimal": "TM5",
        "- PL0Ps": "M50", "- - of these, camera registration": "MR0",
        "minimal, complete visibility": "MC",
        "terminal, on Kileel's list (linear in the trifocal tensor)": "TMK",
        "- of these, minimal": "TMKA", "- - with complete visibility": "TMKAC",
        "- - with partial visibility": "TMKA!C", "- of these, not minimal": "TMK!A",
        "terminal, neither": "TM!CK", "not minimal: epipolar excess, E > 0": "E",
        "not minimal: a star alone, S = 1, E = 0": "S!E", "not minimal: both, S = 1, E > 0": "SE"}


def derived_numbers(minimal):
    """The table of section 6; `minimal` says of each number whether the class is minimal."""
    of_classes = [properties(s) | ({"M"} if minimal[n] else set())
                  for n, s in enumerate(CLASSES.all())]
    rows = {"balanced signatures": CLASSES.signatures}
    for row, letters in ROWS.items():
        holds, _, fails = letters.partition("!")
        rows[row] = sum(set(holds) <= p and not p & set(fails) for p in of_classes)
    rows["terminal, completely visible or on Kileel's list"] = \
        rows["terminal camera-minimal"] - rows["terminal, neither"]
    return rows
