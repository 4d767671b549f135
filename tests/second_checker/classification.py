"""Section 6: classification files."""

from counts import derived_numbers
from features import CLASSES, FEATURES, TABLE, index_of, obstruction
from grammar import Fault, require
from pools import Pool, check_deficient, check_minimal


def table_feature(name):
    if name not in TABLE:
        raise Fault(f"{name} is none of the 27 features")
    return FEATURES[TABLE.index(name)], 3


class File:
    def __init__(self, node):
        self.pools = [Pool(pool, table_feature) for pool in node["pool"]]
        self.indices = [[index_of(f) for f, _, _ in pool.features] for pool in self.pools]
        self.records = [(kind, record) for either in node["record"]
                        for kind in either for record in either[kind]]
        numbers = [record["NUMBER"][0] for _, record in self.records]
        if [pool["POOL"][0] for pool in node["pool"]] != list(range(1, len(self.pools) + 1)) or \
                len(self.pools) > 99 or any(found != sorted(found) for found in self.indices):
            raise Fault("the numbers of pools, or the order of their features")
        if "-" in numbers or any(a >= b for a, b in zip(numbers, numbers[1:])) or \
                any(len(record["kernel"]) > 11 for _, record in self.records):
            raise Fault("the numbers of records, or more than 11 kernel vectors")

    def check(self, kind_and_record):
        kind, record = kind_and_record
        number, at, chosen = record["NUMBER"][0], record["POOL"][0] - 1, []
        require(number < len(CLASSES.all()) and 0 <= at < len(self.pools), "no such class or pool")
        pool, indices = self.pools[at], self.indices[at]
        require(pool.meets_requirements, "the requirements of section 2")
        for index, count in enumerate(CLASSES.all()[number]):
            require(indices.count(index) >= count, "the pool has too few instances")
            start = indices.index(index) if count else 0
            chosen += range(start, start + count)
        excess, star = obstruction([pool.features[i][0] for i in chosen])
        if kind == "deficient-record":
            check_deficient(record, pool, chosen, excess, star)
        else:
            require(not any(excess) and not star, "the class is not minimal")
            check_minimal(record, pool, chosen)

    def conclude(self, held):
        """(how many classes have no record that holds, the derived numbers)."""
        minimal = {record["NUMBER"][0]: kind == "minimal-record" for kind, record in held}
        missing = len(CLASSES.all()) - len(minimal)
        return missing, {} if missing else derived_numbers(minimal)
