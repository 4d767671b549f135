"""Section 7: problem files, the verdict on one problem in two or three views."""

from features import CLASSES, Feature, index_of, obstruction, parse_feature, weight
from general import multiplicities
from grammar import Fault, require
from pools import Pool, check_camera_minimal, check_deficient, check_minimal

RULES = ("unseen-line", "free-line", "pin-seen-once", "pin-seen-twice", "unseen-point", "bare-point",
         "point-on-line", "point-and-pin")


def forgotten(feature, i):
    return Feature(feature.point, feature.lines[:i] + feature.lines[i + 1:])


def results(rule, feature, views):
    """What a rule makes of a feature: a list of Features, None for nothing."""
    point, lines = feature
    if rule == "unseen-line":
        return [forgotten(feature, i) if point is not None else None
                for i, line in enumerate(lines) if not line]
    if point is None:
        return [None] if rule == "free-line" and 1 <= len(lines[0]) <= 2 else []
    if rule in ("pin-seen-once", "pin-seen-twice"):
        times = 1 if rule == "pin-seen-once" else 2
        return [forgotten(feature, i) for i, line in enumerate(lines)
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
    reduced = list(features)
    for position, rule, result in steps:
        require(position <= len(reduced), "no such POSITION")
        require(result in results(rule, reduced[position - 1], views), f"{rule} gives something else")
        reduced[position - 1:position] = [result] if result else []
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
    """(verdict with K, excess, S, NUMBER)."""
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
        number = CLASSES.number(tuple(map(indices.count, range(27))))
    balanced = sum(map(weight, features)) == cameras
    verdict = "obstructed" if star or any(excess) else "minimal" if balanced else "camera-minimal"
    return verdict, excess, star, number


class File:
    """The only record of a problem file is the file."""

    def __init__(self, node):
        self.notation, = node["problem"][0]["NOTATION"]
        named = [parse_feature(name) for count, name in multiplicities(self.notation)
                 for _ in range(count)]
        made = [parse_feature(step["FEATURE"][0]) if step["FEATURE"] else (None, named[0][1])
                for step in node["reduce"]]
        self.features, self.views = [feature for feature, _ in named], named[0][1]
        self.steps = [(step["POSITION"][0], step["RULE"][0], feature)
                      for step, (feature, _) in zip(node["reduce"], made)]
        verdict, self.pool, self.proof = node["verdict"][0], None, None
        self.verdict = " ".join(map(str, verdict["words"][1:] + verdict["K"]))
        if node["proof"]:
            self.pool = Pool(node["pool"][0], parse_feature)
            (self.kind, (self.proof,)), = node["proof"][0].items()
        if any(views != self.views for _, views in named + made) or len(named) > 1000 or \
                bool(verdict["K"]) == bool(self.proof) or self.proof and (
                    len(self.pool.cameras) + 1 != self.views or node["pool"][0]["POOL"] != [1] or
                    len(self.proof["kernel"]) > 11):
            raise Fault("the views, more than 1,000 features, a proof that is missing or not due")
        self.records = [self]

    def check(self, _):
        lifted = lift(reduce(self.features, self.steps, self.views), self.views)
        verdict, excess, star, number = verdict_due(self.features, lifted, self.views)
        require(self.verdict == verdict, f"the verdict is {verdict}")
        if self.proof:
            self.check_proof(lifted, excess, star, number)

    def check_proof(self, lifted, excess, star, number):
        obstructed = self.verdict == "obstructed"
        kind = "deficient-record" if obstructed else \
            "minimal-record" if self.verdict == "minimal" else "camera-record"
        require((self.kind, self.proof["NUMBER"], self.proof["POOL"]) == (kind, [number], [1]),
                "the kind of proof, NUMBER or POOL")
        features = lifted if obstructed else self.features
        require([f for f, _, _ in self.pool.features] == features, "the features of the pool")
        require(self.pool.meets_requirements, "the requirements of section 2")
        if obstructed:
            check_deficient(self.proof, self.pool, range(len(features)), excess, star)
        elif kind == "minimal-record":
            check_minimal(self.proof, self.pool, range(len(features)))
        else:
            check_camera_minimal(self.proof, self.pool, range(len(features)))

    def conclude(self, _):
        return 0, {}
