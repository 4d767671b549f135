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
import itertools
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


def draw_lines(draw, count):
    """(lines, number of points) of some lines through several points each, which may meet. The points have
    an order in which each lies on at most one line through two earlier ones."""
    lines, points = [], 0
    for _ in range(count):
        old = draw.sample(range(points), min(points, draw.choice((0, 1, 1, 2))))
        if any(len(set(old) & set(line)) > 1 for line in lines):
            old.pop()
        new = draw.choice((2, 2, 3, 3, 4)) - len(old)
        lines.append(old + list(range(points, points + new)))
        points += new
    return lines, points


def draw_feature(draw, views, letters):
    """(notation, conditions on the images) of points with pins: one, if there are no letters, else those
    on lines through several of them, a line for each letter. Nothing if no view sees one of them."""
    shared, points = draw_lines(draw, len(letters)) if letters else ([], 1)
    lines = list(zip(letters, shared))
    for point in range(points):
        pins = draw.choice((0, 0, 0, 0, 1, 2) if letters else (0, 0, 1, 1, 2, 3))
        lines += [(letter, [point]) for letter in "abc"[:pins]]
    point_seen = [some_views(draw, views) for _ in range(points)]
    line_seen = [some_views(draw, views) for _ in lines]
    see_what_is_determined(views, [on_it for _, on_it in lines], point_seen, line_seen)
    through = [[i for i, (_, on_it) in enumerate(lines) if point in on_it] for point in range(points)]
    if not all(line_seen) or any(not seen and len(own) < 2 for seen, own in zip(point_seen, through)):
        return None
    in_space = 3 * points + sum(2 if len(on_it) == 1 else 4 - 2 * len(on_it) for _, on_it in lines)
    in_images = 2 * sum(map(len, point_seen)) + sum(
        2 * len(seen) - sum(len(seen & point_seen[point]) for point in on_it)
        for seen, (_, on_it) in zip(line_seen, lines))
    text = " + ".join("/".join(
        symbol(view, point_seen[point], {lines[i][0]: line_seen[i] for i in through[point]})
        for view in range(views)) for point in range(points))
    return text, in_images - in_space


def see_what_is_determined(views, lines, point_seen, line_seen):
    """A view that sees two lines of a point sees the point, one that sees two points of a line the line."""
    through = [[i for i, on_it in enumerate(lines) if point in on_it] for point in range(len(point_seen))]
    for view in range(views):
        changed = True
        while changed:
            changed = False
            for here, others, incident in ((line_seen, point_seen, lines), (point_seen, line_seen, through)):
                for seen, neighbours in zip(here, incident):
                    if view not in seen and sum(view in others[i] for i in neighbours) > 1:
                        seen.add(view)
                        changed = True


def symbol(view, point, lines):
    """What the view sees of a point and the lines through it."""
    seen = "".join(sorted(letter for letter, line in lines.items() if view in line))
    return ("P" if view in point else "") + seen or "-"


def draw_free_line(draw, views):
    line = some_views(draw, views)
    return ("/".join("a" if view in line else "-" for view in range(views)), 2 * len(line) - 4) if line else None


def draw_problem(draw, prefix):
    """A balanced problem, as notation."""
    each, all_of_them = CAMERAS[prefix]
    views = draw.choice((2, 3, 3, 4, 4, 5, 6, 7, 8))
    due = each * views + all_of_them
    features, letters, refused = [], "LMNOQRSTUVWXYZ", 0
    while due > 0 and refused < 50:
        lines = draw.choices((0, 1, 2, 3, None), (65, 8, 5, 2, 20))[0]
        feature = draw_free_line(draw, views) if lines is None else draw_feature(draw, views, letters[:lines])
        if feature and 0 <= feature[1] <= due:
            features.append(feature[0])
            letters = letters[lines or 0:]
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
