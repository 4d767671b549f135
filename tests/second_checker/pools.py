"""Sections 2, 3 and 5: pools, and the records that rest on the matrix J of some of their features."""

from functools import cache, cached_property
from math import gcd

from algebra import apply, cross, determinant, dot, eliminate, quaternion_matrix
from features import problem_of
from general import jacobian
from grammar import Fault, chunks, require


class Pool:
    """The integers of section 2. `named` turns a FEATURE into a Feature and its number of views."""

    def __init__(self, node, named):
        self.cameras = chunks(node["INT"], 7)
        self.features = []
        for placed in node["feature"]:
            feature, views = named(placed["FEATURE"][0])
            point, *pins = chunks(placed["INT"], 3)
            if views != len(self.cameras) + 1 or len(pins) != len(feature.lines):
                raise Fault(f"the views, or the pins, of {placed['FEATURE'][0]}")
            self.features.append((feature, point, pins))
        if len(self.features) > 1000:
            raise Fault("more than 1,000 features in a pool")

    @cached_property
    def meets_requirements(self):
        """Those of section 2."""
        return self.cameras[0][4] != 0 and all(any(c[:4]) for c in self.cameras) and \
            all(self.feature_meets(*feature) for feature in self.features)

    def feature_meets(self, feature, point, pins):
        for view, numbers in enumerate([[1] + [0] * 6] + self.cameras):
            rotation = quaternion_matrix(*numbers[:4])
            image = [a + b for a, b in zip(apply(rotation, point), numbers[4:])]
            if view in (feature.point or ()) and image[2] == 0 or any(
                    pin[2] == 0 or view in line and not any(cross(image, apply(rotation, pin)))
                    for line, pin in zip(feature.lines, pins)):
                return False
        return True

    @cache
    def rows(self, number):
        """Section 3: (rows of a feature: own columns, camera columns; how many are own)."""
        feature, point, pins = self.features[number]
        problem = problem_of(feature, len(self.cameras) + 1)
        rows, width = jacobian(problem, self.cameras, sum(pins, point))
        return rows, width - (11 if len(self.cameras) == 2 else 5)

    @cache
    def conditions(self, number):
        """What the feature asks of the camera part of a motion, over the rationals."""
        return eliminate(*self.rows(number))[1]

    def jacobian(self, numbers):
        """(J of these features, the number of own columns)."""
        parts = [self.rows(number) for number in numbers]
        own_in_all, before, matrix = sum(own for _, own in parts), 0, []
        for rows, own in parts:
            matrix += [[0] * before + row[:own] + [0] * (own_in_all - before - own) + row[own:]
                       for row in rows]
            before += own
        return matrix, own_in_all


def without(matrix, rows, columns):
    """The matrix without these rows and columns, numbered from 1."""
    return [[x for i, x in enumerate(row, 1) if i not in columns]
            for number, row in enumerate(matrix, 1) if number not in rows]


def check_minimal(record, pool, numbers):
    require(determinant(pool.jacobian(numbers)[0]) == record["MINOR"][0], "the determinant")


def check_camera_minimal(record, pool, numbers):
    matrix, own = pool.jacobian(numbers)
    require(record["OWN"][-1] <= own and len(record["OWN"]) == len(matrix[0]) - len(matrix),
            "the deleted columns")
    require(determinant(without(matrix, (), record["OWN"])) == record["MINOR"][0], "the minor")


def check_deficient(record, pool, numbers, excess, star):
    """Item 4 of section 6; `excess` and `star` are due."""
    deficiency, columns = max(sum(excess), star), record["COLUMN"]
    require(deficiency and (record["EXCESS"], record["STAR"]) == (excess, [star]) and
            record["RANK"] == [11 - deficiency], "the obstruction")
    require({len(record["ROW"]), len(columns), len(record["kernel"])} == {deficiency},
            "how much is deleted")
    matrix, own = pool.jacobian(numbers)
    require(record["ROW"][-1] <= len(matrix), "a ROW")
    left = without(matrix, record["ROW"], [own + column for column in columns])
    require(determinant(left) == record["MINOR"][0], "the minor")
    for i, kernel in enumerate(vector["ENTRY"] for vector in record["kernel"]):
        at = [kernel[column - 1] for column in columns]
        require(at[i] > 0 and not any(at[:i] + at[i + 1:]) and gcd(*kernel) == 1,
                "the form of a kernel vector")
        require(not any(dot(row, kernel) for n in numbers for row in pool.conditions(n)),
                "a kernel vector moves an image")
