#!/usr/bin/python3
"""Are random problems without an answer? Draws balanced problems of each kind of cameras in 2 to 8
views, with partial visibility and shared lines, has plprove certify them, and plcheck replay that.
And no reason speaks against a minimal problem: reasons_against looks for one, for the first 20 of
each kind.

    random_problems.py PLPROVE PLCHECK REASONS_AGAINST [COUNT [SEED]]     COUNT of each kind

Status 1 if one has no certificate, or a wrong one. Prints the seed, which is new each time unless
it is given, and draws the same problems again.
"""
import collections
import pathlib
import random
import subprocess
import sys
import tempfile

# The parameters of m cameras of each kind up to motions of space: those of each, and of all less
# these motions (docs/families.md).
CAMERAS = {"": (6, -7), "projective: ": (11, -15), "shared-focal: ": (6, -6), "focal: ": (7, -7),
           "shared-focal-center: ": (6, -4), "shared-k: ": (6, -2), "upright: ": (4, -5),
           "upright-shared-focal: ": (4, -4), "upright-focal: ": (5, -5)}


def some_views(draw, views):
    """Some views; often all, or nearly all; rarely less than two."""
    share = draw.choice((0.5, 0.7, 0.9, 1))
    found = {view for view in range(views) if draw.random() < share}
    return found if len(found) > 1 or draw.random() < 0.03 else some_views(draw, views)


def symbols(views, point, pins, shared=(), letter=""):
    """One feature: what each view sees of a point, its pins and a shared line."""
    text = []
    for view in range(views):
        seen = (letter if view in shared else "") + \
            "".join(chr(ord("a") + i) for i, pin in enumerate(pins) if view in pin)
        text.append(("P" if view in point else "") + seen or "-")
    return "/".join(text)


def draw_point(draw, views):
    """(notation, conditions on the images) of a point with pins."""
    point = some_views(draw, views)
    pins = [some_views(draw, views) for _ in range(draw.choice((0, 0, 1, 1, 2, 3)))]
    for view in range(views):
        if sum(view in pin for pin in pins) > 1:
            point.add(view)  # two lines are seen, so their point is
    conditions = 2 * len(point) - 3 + sum(
        sum(1 if view in point else 2 for view in pin) - 2 for pin in pins)
    drawn = [pin for pin in pins if pin]
    if len(drawn) < len(pins) or not point and len(pins) < 2:
        return None  # what no view sees
    return symbols(views, point, pins), conditions


def draw_free_line(draw, views):
    line = some_views(draw, views)
    return (symbols(views, (), [line]), 2 * len(line) - 4) if line else None


def draw_shared_line(draw, views, letter):
    """Points on a line of their own."""
    points = [some_views(draw, views) for _ in range(draw.choice((2, 2, 3, 3, 4)))]
    line = some_views(draw, views)
    conditions = -6 - (len(points) - 2)
    for view in range(views):
        seen = sum(view in point for point in points)
        if seen > 1:
            line.add(view)
        conditions += 2 + seen if view in line else 2 * seen
    if not all(points) or not line:
        return None
    return " + ".join(symbols(views, point, [], line, letter) for point in points), conditions


def draw_problem(draw, prefix):
    """A balanced problem, as notation."""
    each, all_of_them = CAMERAS[prefix]
    views = draw.choice((2, 3, 3, 4, 4, 5, 6, 7, 8))
    due = each * views + all_of_them
    features, letters, refused = [], iter("LMNO"), 0
    while due > 0 and refused < 50:
        kind = draw.random()
        feature = draw_point(draw, views) if kind < 0.65 else \
            draw_free_line(draw, views) if kind < 0.9 else \
            draw_shared_line(draw, views, next(letters, "Q"))
        if feature and "Q" not in feature[0] and 0 <= feature[1] <= due:
            features.append(feature[0])
            due -= feature[1]
        else:
            refused += 1
    if due > 0 or len(features) > 60:
        return draw_problem(draw, prefix)
    counts = collections.Counter(features)
    return prefix + " + ".join(text if count == 1 or "+" in text else f"{count}*{text}"
                               for text, count in sorted(counts.items())
                               for _ in range(count if "+" in text else 1))


def main():
    plprove, plcheck, reasons_against, *given = sys.argv[1:]
    count, seed = map(int, given + [1000, random.randrange(10**9)][len(given):])
    draw = random.Random(seed)
    drawn = {prefix: [draw_problem(draw, prefix) for _ in range(count)] for prefix in CAMERAS}
    with tempfile.TemporaryDirectory() as folder:
        mine, records = pathlib.Path(folder) / "mine.txt", pathlib.Path(folder) / "mine.plc"
        mine.write_text("".join(f"{text}\n" for texts in drawn.values() for text in texts))
        print(f"seed {seed}", flush=True)
        certified = subprocess.run([plprove, "certify", "--list", mine, "-o", records], check=False)
        checked = subprocess.run([plcheck, "--quiet", "--expect-list", mine, records], check=False)
    first = "".join(f"{text}\n" for texts in drawn.values() for text in texts[:20])
    against = subprocess.run([reasons_against], input=first.encode(), check=False)
    sys.exit(certified.returncode or checked.returncode or against.returncode)


if __name__ == "__main__":
    main()
