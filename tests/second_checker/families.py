"""Section 13: the problems of a family up to isomorphism, and the numbers of a family."""

from itertools import combinations, permutations

from cameras import dimension
from parts import span


def canonical(points, free):
    """Of a problem that is seen everywhere: `points` are (the long lines through it, its pins)."""
    used = sorted({j for lines, _ in points for j in lines})
    return min(sorted((tuple(sorted(order[used.index(j)] for j in lines)), pins)
                      for lines, pins in points)
               for order in permutations(range(len(used)))), free


def through(lines, count, pins):
    """The first argument of `canonical`: `count` points on long lines."""
    return [(tuple(j for j, on in enumerate(lines) if i in on), pins[i]) for i in range(count)]


def hashable(form):
    return tuple(form[0]), form[1]


def configurations(count):
    """Sets of long lines on `count` points, one of each class: point after point, item 4."""
    found = [[]]
    for new in range(count):
        larger = {}
        for lines in found:
            joined = {pair for line in lines for pair in combinations(line, 2)}
            choices = [lines]
            choices += [lines[:j] + [lines[j] + [new]] + lines[j + 1:] for j in range(len(lines))]
            choices += [lines + [[*pair, new]] for pair in combinations(range(new), 2)
                        if pair not in joined]
            for choice in choices:
                points = through(choice, new + 1, [0] * (new + 1))
                larger.setdefault(hashable(canonical(points, 0)), choice)
        found = list(larger.values())
    return found


def distributions(total, count):
    if count == 0:
        return [()] if total == 0 else []
    return [(first, *rest) for first in range(total + 1)
            for rest in distributions(total - first, count - 1)]


def kind_of(family):
    """Its cameras."""
    return "calibrated" if family == "plmp" else family


def has_size(kind, points, views):
    of_two = dimension(kind, 2)
    return of_two <= 7 if views == 2 else views == 3 or points < of_two


def family_classes(family):
    """{(number of views, canonical form)} of all problems of a family."""
    kind, found = kind_of(family), set()
    for p in range(9):
        for lines in configurations(p):
            d = sum(len(on) - 2 for on in lines)
            for m in range(2, 13):
                cameras = dimension(kind, m)
                if not has_size(kind, p, m):
                    continue
                # 3p - 2d + 4f + 2a + D = m (2p - d + 2f + a): what f and a may be.
                left = 3 * p - 2 * d + cameras - m * (2 * p - d)
                pairs = [(f, (left - (2 * m - 4) * f) // (m - 2))
                         for f in range(left // (2 * m - 4) + 1)
                         if (left - (2 * m - 4) * f) % (m - 2) == 0] if m > 2 else \
                    [(0, 0)] if left == 0 else []
                found |= {(m, hashable(canonical(through(lines, p, pins), f)))
                          for f, a in pairs for pins in distributions(a, p)}
    return found


def member(family, problem):
    """The class of a problem if it is of the family, else None."""
    sizes, p = [len(on) for on in problem.on], len(problem.points)
    if 2 in sizes or problem.cameras != kind_of(family) or \
            not problem.balanced() or not problem.sees_everything() or \
            problem.views == 2 and min(sizes, default=3) < 3 or \
            not has_size(problem.cameras, p, problem.views):
        return None
    pins = [problem.on.count([i]) for i in range(p)]
    long_lines = [on for on in problem.on if len(on) > 2]
    return problem.views, hashable(canonical(through(long_lines, p, pins), sizes.count(0)))


def special(problem):
    """Four points on a line, or six points in a plane."""
    on = dict(enumerate(problem.on))
    return any(len(points) > 3 for points in problem.on) or len(problem.points) == 6 and any(
        len(span(on, three, [])[1]) == 6 for three in combinations(range(6), 3))


def one_solution(problem):
    """By the first two items of *Upper bounds*, which turn out to find all of them."""
    m, axes = problem.views, [on for on in problem.on if len(on) > 2]
    if any(set(a) & set(b) for a, b in combinations(axes, 2)):
        return True
    for axis in axes if all(len(on) != 2 for on in problem.on) else []:
        away = [on for on in problem.on if not set(on) & set(axis)]
        n = 3 * m - 2 - (m - 2) * len(away)
        powers = [m - 2 for on in problem.on if len(on) == 1 and on[0] in axis]
        powers += [2 * m - 3 - (m - 2) * sum(i in on for on in away)
                   for i in range(len(problem.points)) if i not in axis]
        product = [1]
        for a in powers:
            product = [sum(product[max(0, k - a):k + 1]) for k in range(len(product) + a)]
        if n > 1 and min(powers, default=0) >= 0 and sum(powers) == 2 * (n - 2):
            return product[n - 2] - sum(product[n - 1:n]) == 1
    return False


def family_numbers(family, records):
    """The table of *Families*."""
    def minimal(records, views=None):
        return sum(r.minimal and views in (None, r.problem.views) for r in records)

    if family != "projective":
        most = max((r.problem.views for r in records if r.minimal), default=1)
        return {"balanced": len(records), "minimal": minimal(records),
                **{f"minimal, in {m} views": minimal(records, m) for m in range(2, most + 1)}}
    few = [r for r in records if len(r.problem.points) < 7]
    seven = [r for r in records if len(r.problem.points) == 7]
    counted = [r for r in records if r.minimal and (len(r.problem.points) < 7 or
                                                    r.problem.views == 2)]
    return {"balanced, fewer than seven points": len(few),
            "minimal, fewer than seven points": minimal(few),
            "not minimal, fewer than seven points": len(few) - minimal(few),
            "- no four on a line, no six in a plane":
                sum(not r.minimal and not special(r.problem) for r in few),
            "minimal, seven points in two views": minimal(seven, 2),
            "minimal, seven points in three views": minimal(seven, 3),
            "minimal": len(counted),
            "- with one solution": sum(one_solution(r.problem) for r in counted)}
