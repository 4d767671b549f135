"""Section 13: kinds of cameras, their dimensions and matrices."""

from algebra import cross, dot, quaternion_matrix

# Of cameras that are calibrated in part: the shared numbers, those of a turn, those after t.
IN_PART = {"shared-focal": (1, 4, 0), "focal": (1, 3, 2), "shared-focal-center": (3, 4, 0),
           "shared-k": (5, 4, 0), "upright": (0, 2, 0), "upright-shared-focal": (1, 2, 0),
           "upright-focal": (1, 2, 1)}
KINDS = {"calibrated", "projective", *IN_PART}
# A turn about any line takes them to such cameras.
TURNING = {"calibrated", *(kind for kind, (_, turn, _) in IN_PART.items() if turn > 2)}


def counts(kind):
    """(shared integers of a record, integers of each of its cameras)."""
    if kind in IN_PART:
        shared, turn, own = IN_PART[kind]
        return shared, turn + 3 + own
    return 0, 12 if kind == "projective" else 7


def dimension(kind, views):
    if kind in IN_PART:
        shared, numbers = counts(kind)
        return shared + (numbers - 1) * (views - 1) - 1
    return 11 * views - 15 if kind == "projective" else 6 * views - 7


def unknowns_of_one(kind):
    """Those of a camera from the third on."""
    return dimension(kind, 4) - dimension(kind, 3)


def conic(shared):
    g, h, b, c, e = {0: (0, 1, 0, 0, 1), 1: (0, 1, 0, 0, *shared), 3: (0, 1, *shared),
                     5: shared}[len(shared)]
    return [[1, g, b], [g, h, c], [b, c, e]]


def turned(w, a, v):
    """The columns of M, without what r and s do."""
    adjugate = [cross(w[1], w[2]), cross(w[2], w[0]), cross(w[0], w[1])]
    wv = [dot(row, v) for row in w]
    columns = []
    for j, unit in enumerate(([1, 0, 0], [0, 1, 0], [0, 0, 1])):
        across = cross(v, unit)
        columns.append([(a * a * dot(w[0], adjugate[0]) - dot(v, wv)) * unit[i] +
                        2 * (v[i] * wv[j]) + 2 * (a * dot(adjugate[i], across)) for i in range(3)])
    return columns


def in_part(kind, shared, numbers, chart, second):
    """The camera matrix of cameras that are calibrated in part."""
    _, turn, own = IN_PART[kind]
    a, *v = chart.moving(numbers[:turn], 1)
    t = chart.moving(numbers[turn:turn + 3], 1 if second else 0)
    r, s = [*chart.moving(numbers[turn + 3:]), 0][:2] if own else [1, 0]
    columns = turned(conic(shared), a, [0, *v, 0] if turn == 2 else [*v, 0][:3])
    columns = [[r * x - s * y, s * x + r * y, z] for x, y, z in columns]
    return [[*row, t[i]] for i, row in enumerate(zip(*columns))]


def matrices(kind, shared, cameras, chart):
    """The camera matrices with their motions, as a record gives them."""
    found = [[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]]
    shared = chart.moving(shared)
    for view, numbers in enumerate(cameras, 1):
        second = view == 1
        if kind == "projective":
            entries = chart.moving(numbers, 5 if second else 1)
            found.append([entries[i:i + 4] for i in (0, 4, 8)])
        elif kind == "calibrated":
            turn = chart.moving([0, 0, 0])
            columns = [[x + y for x, y in zip(column, cross(turn, column))]
                       for column in zip(*quaternion_matrix(*numbers[:4]))]
            found.append(list(zip(*columns, chart.moving(numbers[4:], 1 if second else 0))))
        else:
            found.append(in_part(kind, shared, numbers, chart, second))
    return found
