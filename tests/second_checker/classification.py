"""Sections 5 and 6: classification files, their records, and the derived numbers."""

from math import gcd

from algebra import determinant, dot, eliminate
from features import CLASSES, FEATURES, PAIRS, RELABELINGS, TABLE, Pool, index_of, obstruction
from lines import MINOR, MODULUS, Q, Fault, Reader, Refused, require


class Deficient:
    """A deficient-record after its NUMBER and POOL."""

    def __init__(self, reader):
        count = (0, 999999)
        self.rank, *self.excess, self.star = reader.line(
            "rank", count, "excess", count, count, count, "star", count)
        reader.take("delete rows")
        self.rows = reader.ascending()
        reader.take("columns")
        self.columns = reader.ascending(11)
        reader.line()
        self.minor, = reader.line("minor", MINOR)
        self.kernels, entry = [], (1 - 10**1000, 10**1000 - 1)
        while reader.next_is("kernel") or not self.kernels:
            self.kernels.append(reader.line("kernel", *[entry] * 11))
        if len(self.kernels) > 11:
            raise Fault("more than 11 kernel vectors")

    def check(self, pool, numbers, excess, star):
        """Item 4 of section 6; `excess` and `star` are due."""
        deficiency = max(sum(excess), star)
        require(deficiency and (self.excess, self.star) == (excess, star) and
                self.rank == 11 - deficiency, "the obstruction")
        require({len(self.rows), len(self.columns), len(self.kernels)} == {deficiency},
                "how much is deleted")
        require(self.rows[-1] <= sum(len(pool.rows(n)[0]) for n in numbers), "a ROW")
        require(pool.minor(numbers, self.rows, self.columns) == self.minor, "the minor")
        for i, kernel in enumerate(self.kernels):
            at = [kernel[column - 1] for column in self.columns]
            require(at[i] > 0 and not any(at[:i] + at[i + 1:]) and gcd(*kernel) == 1,
                    "the form of a kernel vector")
            require(not any(dot(row, kernel) for n in numbers for row in pool.conditions(n)),
                    "a kernel vector moves an image")


class Eliminated(Pool):
    """A pool that keeps, for each feature, J without the feature's own unknowns."""

    def __init__(self, reader, named):
        super().__init__(reader, named)
        self.blocks, self.exact = {}, {}

    def block(self, number):
        if number not in self.blocks:
            rows, own = self.rows(number)
            self.blocks[number] = own, *eliminate(rows, own, Q)
        return self.blocks[number]

    def conditions(self, number):
        """What the feature asks of the camera part of a motion, over the rationals."""
        if number not in self.exact:
            self.exact[number] = eliminate(*self.rows(number))[1]
        return self.exact[number]

    def minor(self, numbers, deleted=(), columns=()):
        """The determinant modulo q of J without some rows and camera columns. The features' own
        unknowns are eliminated first: each feature by itself."""
        product, before, camera_rows = 1, 0, []
        for number in numbers:
            own, factor, block = self.block(number)
            if deleted:
                rows = self.rows(number)[0]
                kept = [row for i, row in enumerate(rows, before + 1) if i not in deleted]
                before += len(rows)
                factor, block = eliminate(kept, own, Q)
            # The own rows of this feature go before the camera rows of the earlier ones.
            product = product * factor * (-1) ** (len(camera_rows) * own) % Q
            camera_rows += block
        kept = [i for i in range(11) if i + 1 not in columns]
        if not product:
            return 0
        require(len(camera_rows) == len(kept), "J without what is deleted is not square")
        return product * determinant([[row[i] for i in kept] for row in camera_rows]) % Q


def table_feature(name):
    if name not in TABLE:
        raise Fault(f"{name} is none of the 27 features")
    return FEATURES[TABLE.index(name)], 3


def read(data):
    """(pools, records): a record is (NUMBER, POOL, MINOR or Deficient)."""
    reader, pools, records = Reader(data, "classification"), [], []
    reader.line(MODULUS)
    while reader.next_is("pool"):
        reader.line("pool", (len(pools) + 1, min(99, len(pools) + 1)))
        pools.append(Eliminated(reader, table_feature))
        indices = [index_of(feature) for feature, _, _ in pools[-1].features]
        if indices != sorted(indices):
            raise Fault("the order of the features of a pool")
        pools[-1].indices = indices
    while not reader.ended():
        kind = reader.word("minimal", "deficient")
        number, pool = reader.take((0, 999999), (0, 999999))
        if records and number <= records[-1][0]:
            raise Fault("numbers of records that do not ascend")
        claim = reader.line(MINOR)[0] if kind == "minimal" else Deficient(reader)
        records.append((number, pool, claim))
    return pools, records


def check_record(pools, number, pool, claim):
    require(number < len(CLASSES.all()) and 1 <= pool <= len(pools), "no such class or pool")
    pool, numbers = pools[pool - 1], []
    pool.require()
    for index, count in enumerate(CLASSES.all()[number]):
        require(pool.indices.count(index) >= count, "the pool has too few instances")
        start = pool.indices.index(index) if count else 0
        numbers += range(start, start + count)
    excess, star = obstruction([pool.features[i][0] for i in numbers])
    if isinstance(claim, Deficient):
        return claim.check(pool, numbers, excess, star)
    require(not any(excess) and not star, "the class is not minimal")
    require(pool.minor(numbers) == claim, "the determinant")


def check(data, every=1):
    """Replays the first of so many records each time: a dictionary of what the checker prints."""
    pools, records = read(data)
    minimal, refused = {}, []
    for record in records[::every]:
        try:
            check_record(pools, *record)
            minimal[record[0]] = not isinstance(record[2], Deficient)
        except Refused as why:
            refused.append(f"class {record[0]}: {why}")
    result = {"hold": len(minimal), "refused": refused}
    if every == 1:
        result["missing"] = len(CLASSES.all()) - len(minimal)
        if not result["missing"]:
            result["claims"] = derived_numbers(minimal)
    return result


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
    swapped = []
    for order in RELABELINGS:
        swapped.append([signature[i] for i in order])
        for i in (12, 14, 16):
            swapped[-1][i], swapped[-1][i + 1] = swapped[-1][i] + swapped[-1][i + 1], 0
    return found | ({"T"} if max(swapped) == list(signature) else set())  # T: stands for its swaps


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
