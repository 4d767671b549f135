"""Section 9: degree files whose records have fibres."""

from algebra import apply, cross, dot, quaternion_matrix
from features import CLASSES, FEATURES, TABLE, obstruction
from fibre import is_regular, read_fibre
from grammar import Fault, require

VIEWS = (0, 1, 2)


def read_images(node):
    """(index of the feature, [{"point": x, "lines": [...]} a view])."""
    if node["FEATURE"][0] not in TABLE:
        raise Fault("no feature of the table")
    index, numbers, found = TABLE.index(node["FEATURE"][0]), iter(node["LONG"]), []
    for word in node["words"][1:]:
        if word == "view":
            found.append({"point": None, "toward": [], "line": []})
        else:
            vector = [next(numbers) for _ in VIEWS]
            if word == "point":
                found[-1]["point"] = vector
            else:
                found[-1][word].append(vector)
    point, lines = FEATURES[index]
    seen = [v for v in VIEWS if v in (point or ()) or any(v in views for views in lines)]
    images = dict(zip(seen, found))
    for view, image in images.items():
        count, sees = sum(view in views for views in lines), view in (point or ())
        if (image["point"] is not None) != sees or len(image["toward"]) != count * sees or \
                len(image["line"]) != count * (not sees):
            raise Fault("the groups of an image")
        image["lines"] = [cross(image["point"], y) for y in image["toward"]] or image["line"]
    if len(found) != len(seen):
        raise Fault("the views of an image")
    return index, images


class Equations:
    """Those of section 9. A vector is (its view, its three integers)."""

    def __init__(self, records):
        self.list, self.places = [], []
        for index, images in records:
            self.add(FEATURES[index], images)

    def nonzero(self, view, vector):
        require(any(vector), "an image is zero")
        return view, vector

    def auxiliary(self, vector):
        view, (_, y, z) = vector
        return self.nonzero(view, [0, z, -y])

    def add(self, feature, images):
        lines = [{} for _ in feature.lines]  # by view
        for view, image in images.items():
            pins = iter(image["lines"])
            for pin, views in enumerate(feature.lines):
                if view in views:
                    lines[pin][view] = self.nonzero(view, next(pins))
        points = {v: self.nonzero(v, image["point"]) for v, image in images.items() if image["point"]}
        pencils = [line for line in lines if len(line) == 3]
        if feature.point is None:
            ray, first, (j, k) = self.auxiliary(lines[0][0]), 0, (1, 2)
            planes = {view: lines[0][view] for view in (1, 2)}
        else:
            first = min(points)
            ray, (j, k) = points[first], (v for v in VIEWS if v != first)
            planes = {v: self.auxiliary(points[v]) for v in (j, k) if v in points}
            for line in lines:
                planes.update({v: plane for v, plane in line.items() if v not in planes and v not in points})
            self.list += [("epipolar", ray, points[v]) for v in (j, k) if v in points]
        if j in planes and k in planes:
            self.list.append(("incidence", ray, planes[j], planes[k]))
        self.list += [("pencil", *(line[v] for v in VIEWS)) for line in pencils]
        others = [v for v in (j, k) if v in points and v in planes] or \
            [v for v in (j, k) if v in planes]
        self.places.append((ray, planes[others[0]], set(points), lines))


class Cameras:
    """Cameras with these 11 coordinates, numbers modulo q and g."""

    def __init__(self, z):
        self.norms = [1 + dot(z[i:i + 3], z[i:i + 3]) for i in (0, 3)]
        self.centres = [[0, 0, 0], [1, *z[6:8]], list(z[8:11])]
        turns = [quaternion_matrix(1, *z[i:i + 3]) for i in (0, 3)]
        self.transposed = [None, *([list(column) for column in zip(*turn)] for turn in turns)]

    def turned(self, vector):
        view, x = vector
        return apply(self.transposed[view], x) if view else x

    def between(self, a, b):
        """c_a - c_b, for the views of two vectors."""
        return [x - y for x, y in zip(self.centres[a[0]], self.centres[b[0]])]

    def value(self, equation):
        kind, *vectors = equation
        a, b, *rest = vectors
        d = [self.turned(vector) for vector in vectors]
        if kind == "epipolar":
            return dot(self.between(b, a), cross(d[0], d[1]))
        if kind == "pencil":
            return dot(d[0], cross(d[1], d[2]))
        return dot(d[1], self.between(a, b)) * dot(d[2], d[0]) - \
            dot(d[2], self.between(a, rest[0])) * dot(d[1], d[0])

    def check(self, ring, equations):
        """Item 3."""
        def require_unit(*numbers):
            require(not ring.has_common_root(*numbers), "a condition")
        for norm in self.norms:
            require_unit(norm)
        for kind, *vectors in equations.list:
            if kind == "incidence":
                for plane in vectors[1:]:
                    require_unit(dot(self.turned(plane), self.turned(vectors[0])))
        for ray, plane, seen, lines in equations.places:
            d, n = self.turned(ray), self.turned(plane)
            scale, along = dot(n, d), dot(n, self.between(plane, ray))
            require_unit(scale)
            for view in VIEWS:
                there = [scale * x + along * y
                         for x, y in zip(self.between(ray, (view, None)), d)]  # scale (X - c_v)
                if view in seen:
                    require_unit(*there)
                for line in lines:
                    if view in line:
                        first, second = sorted(line)[:2]
                        direction = cross(self.turned(line[first]), self.turned(line[second]))
                        require_unit(*cross(there, direction))


class File:
    def __init__(self, node):
        self.records, due = [], 0
        for record in node["degree"]:
            number, evidence = record["NUMBER"][0], record["evidence"][0]
            if number == "-" or number < due or len(record["image"]) > 11:
                raise Fault("the numbers of records, or more than 11 images")
            if evidence["EDGES"] == [0] and not evidence["EXPONENT"]:
                raise Fault("evidence without an edge or a trace")
            due, (fibre,) = number, record["degree-fibre"]
            lines, count = fibre["fibre-lines"][0], fibre["COUNT"][0]
            residues = lines["polynomial"] + lines["unknown"]
            if count > 10000 or len(lines["unknown"]) != 11 or len(lines["INT"]) != 11 or \
                    any(len(line["RESIDUE"]) != count for line in residues):
                raise Fault("the lines of a fibre")
            self.records.append((number, [read_images(image) for image in record["image"]], fibre))

    def check(self, record):
        number, images, fibre = record
        require(number < len(CLASSES.all()), "no such class")
        signature = CLASSES.all()[number]
        due = [index for index, count in enumerate(signature) for _ in range(count)]
        excess, star = obstruction([FEATURES[index] for index in due])
        require(not any(excess) and not star, "the class is not minimal")
        require([index for index, _ in images] == due, "the images are not those of the class")
        equations = Equations(images)
        ring, unknowns = read_fibre(fibre)
        cameras = Cameras(unknowns)
        for equation in equations.list:
            require(cameras.value(equation).is_zero(), "an equation is not 0")
        # Each equation has at most the degree 2 in each coordinate: differences are derivatives.
        columns = []
        for k in range(11):
            more, less = (Cameras([x + step if i == k else x for i, x in enumerate(unknowns)])
                          for step in (1, -1))
            columns.append([more.value(e) - less.value(e) for e in equations.list])
        require(is_regular(ring, [list(row) for row in zip(*columns)]), "a singular Jacobian")
        cameras.check(ring, equations)

    def conclude(self, _held):
        return 0, {}
