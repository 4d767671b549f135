"""Section 7: problem files, the verdict on one problem in two or three views."""

from algebra import determinant
from classification import Deficient, Eliminated
from features import CLASSES, Feature, index_of, obstruction, parse_feature, spell, weight
from general import multiplicities
from lines import MINOR, MODULUS, Fault, Reader, Refused, require

RULES = ("unseen-line", "free-line", "pin-seen-once", "pin-seen-twice", "unseen-point", "bare-point",
         "point-on-line", "point-and-pin")


def without(feature, i):
    return Feature(feature.point, feature.lines[:i] + feature.lines[i + 1:])


def results(rule, feature, views):
    """What a rule makes of a feature: a list of Features, None for nothing."""
    point, lines = feature
    if rule == "unseen-line":
        return [without(feature, i) if point is not None else None
                for i, line in enumerate(lines) if not line]
    if point is None:
        return [None] if rule == "free-line" and 1 <= len(lines[0]) <= 2 else []
    if rule in ("pin-seen-once", "pin-seen-twice"):
        times = 1 if rule == "pin-seen-once" else 2
        return [without(feature, i) for i, line in enumerate(lines)
                if len(line) == times and line <= point]
    if rule == "unseen-point" and not point and lines and all(lines):
        return [Feature(None, lines) if len(lines) == 1 else None]
    one_and_one = views == 3 and len(point) == 1 and len(lines) == 1
    if rule == "point-on-line" and one_and_one and len(lines[0]) == 3:
        return [Feature(None, lines)]
    across = rule == "point-and-pin" and views == 2 and point and all(lines) and \
        any(line - point for line in lines) and \
        not any(results(earlier, feature, views) for earlier in RULES[:-1])
    if across or rule == "bare-point" and not lines and len(point) <= 1 or \
            rule == "point-and-pin" and one_and_one and len(lines[0] - point) == 1:
        return [None]
    return []


def reduce(features, steps, views):
    reduced = [feature for feature, _ in features]
    for position, rule, text in steps:
        require(position <= len(reduced), "no such POSITION")
        made = [[m] if m else [] for m in results(rule, reduced[position - 1], views)
                if (spell(m, views) if m else "nothing") == text]
        require(made, f"{rule} does not give {text}")
        reduced[position - 1:position] = made[0]
    require(not any(results(rule, f, views) for f in reduced for rule in RULES), "a rule applies")
    return reduced


def lift(reduced, views):
    """The lifted features, in the order of the table; points with eight pins or more first."""
    if views == 2:
        return reduced
    lifted = [Feature(f.point, tuple(line if len(line) != 1 else line | {min(f.point)}
                                     for line in f.lines)) for f in reduced]
    indices = [-1 if len(f.lines) >= 8 else index_of(f) for f in lifted]
    require(None not in indices, "a lifted feature is none of the 27")
    return [f for _, _, f in sorted(zip(indices, range(len(lifted)), lifted))]


def verdict_due(features, lifted, views):
    """(verdict with K, excess, S, NUMBER as text)."""
    cameras = 11 if views == 3 else 5
    total = sum(map(weight, lifted))
    if total != cameras:
        kind = "under" if total < cameras else "over"
        return f"{kind}-constrained {abs(total - cameras)}", None, 0, "-"
    excess, star, number = [0, 0, 0], 0, "-"
    if views == 3 and any(len(f.lines) >= 8 for f in lifted):
        star = 2
    elif views == 3:
        excess, star = obstruction(lifted)
        indices = [index_of(f) for f in lifted]
        number = str(CLASSES.number(tuple(map(indices.count, range(27)))))
    balanced = sum(weight(f) for f, _ in features) == cameras
    verdict = "obstructed" if star or any(excess) else "minimal" if balanced else "camera-minimal"
    return verdict, excess, star, number


class Proof:
    """Modulus, pool and record of a problem file."""

    def __init__(self, reader):
        reader.line(MODULUS)
        reader.line("pool 1")
        self.pool = Eliminated(reader, parse_feature)
        self.kind, self.number = reader.word("minimal", "camera-minimal", "deficient"), "-"
        if reader.next_is("-"):
            reader.take("-")
        else:
            self.number = str(reader.integer(0, 999999))
        self.pool_number = reader.integer(0, 999999)
        if self.kind == "minimal":
            self.minor, = reader.line(MINOR)
        elif self.kind == "deficient":
            self.deficient = Deficient(reader)
        else:
            reader.line()
            reader.take("delete columns")
            self.columns = reader.ascending()
            reader.line()
            self.minor, = reader.line("minor", MINOR)

    def check(self, verdict, features, lifted, views, excess, star, number):
        kind = "deficient" if verdict == "obstructed" else verdict
        require((self.kind, self.number, self.pool_number) == (kind, number, 1),
                "the kind of proof, NUMBER or POOL")
        due = [spell(f, views) for f in lifted] if kind == "deficient" else [n for _, n in features]
        require(self.pool.names == due, "the features of the pool")
        self.pool.require()
        if kind == "deficient":
            return self.deficient.check(self.pool, range(len(due)), excess, star)
        matrix, own = self.pool.jacobian()
        if kind == "camera-minimal":
            require(self.columns[-1] <= own and
                    len(self.columns) == len(matrix[0]) - len(matrix), "the deleted columns")
            matrix = [[x for i, x in enumerate(row, 1) if i not in self.columns] for row in matrix]
        require(determinant(matrix) == self.minor, "the minor")


def read(data):
    reader, steps, features = Reader(data, "problem"), [], []
    reader.take("problem")
    for count, name in multiplicities(reader.rest()):
        features += [(*parse_feature(name), name)] * count
    views = features[0][1]
    while reader.next_is("reduce"):
        reader.take("reduce")
        steps.append((reader.integer(1, 1000), reader.word(), reader.word()))
        if steps[-1][2] != "nothing" and parse_feature(steps[-1][2])[1] != views:
            raise Fault("the views of a FEATURE")
        reader.line()
    reader.take("verdict")
    verdict = reader.word("minimal", "camera-minimal", "obstructed", "under-constrained",
                          "over-constrained")
    counted = verdict.endswith("-constrained")
    if counted:
        verdict += f" {reader.integer(1, 999999)}"
    reader.line()
    proof = None if counted else Proof(reader)
    if not reader.ended() or len(features) > 1000 or any(v != views for _, v, _ in features) or \
            proof and len(proof.pool.cameras) + 1 != views:
        raise Fault("a line after the last, the views, or more than 1,000 features")
    return [(feature, name) for feature, _, name in features], views, steps, verdict, proof


def check(data, every=1):
    features, views, steps, verdict, proof = read(data)
    try:
        lifted = lift(reduce(features, steps, views), views)
        due = verdict_due(features, lifted, views)
        require(verdict == due[0], f"the verdict is {due[0]}")
        if proof:
            proof.check(verdict, features, lifted, views, *due[1:])
    except Refused as why:
        return {"hold": 0, "refused": [str(why)]}
    return {"hold": 1, "refused": []}
