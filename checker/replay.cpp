#include "checker/jacobian.h"
#include "checker/report.h"

#include <numeric>

namespace checker {
/// The instances of each feature that a class may use, and how many the file has.
struct Pool {
    std::array<std::vector<Block>, feature_count> blocks{};
    Signature instances{};
    bool holds = true;
};

/// A record as written. The numbers: class, pool and, if `deficient`, rank, excesses and star.
struct Record {
    std::size_t line = 0;
    Numbers numbers{}, rows{}, columns{};
    Residue minor{};
    std::vector<Motion> kernel{};
};

static Pool read_pool(Reader& reader, std::size_t number, FileReport& report) {
    Pool pool;
    if (number > 99) reader.fail("pool", "at most 99 pools");
    const Numbers cameras =
        reader.take(say("pool ", number, " $ camera 2 quaternion @ @ @ @ translation @ @ @",
                        " $ camera 3 quaternion @ @ @ @ translation @ @ @ $"));
    for (std::size_t i = 0, count = 0; count == 0 || reader.comes("feature"); ++count) {
        const std::size_t line = reader.line();
        if (count == 1000) reader.fail("feature", "at most 1000 features in a pool");
        reader.take("feature");
        const std::string_view name = reader.word();
        while (i < feature_count && features[i].notation != name) ++i;
        if (i == feature_count) reader.fail(name, "a feature, in the order of the table");
        std::string vectors = "point @ @ @";
        for (std::size_t pin = 0; pin < features[i].pins; ++pin) vectors += " pin @ @ @";
        const Numbers numbers = reader.take(vectors + " $");
        try {
            Rows rows = jacobian_rows(features[i], numbers, cameras);
            if (pool.instances[i]++ < camera_unknowns / features[i].weight())
                pool.blocks[i].push_back(eliminate(features[i].unknowns(), std::move(rows)));
        } catch (const Refused& refused) {
            report.refuse(line, say("pool ", number, ": ", refused.reason));
            pool.holds = false;
        }
    }
    return pool;
}

/// Strictly ascending numbers; as many rows are deleted as camera columns, at most 11.
static Numbers read_ascending(Reader& reader, std::int64_t largest) {
    Numbers list;
    do list.push_back(reader.integer(list.empty() ? 1 : list.back() + 1, largest));
    while (list.size() < camera_unknowns && !reader.at_end() && !reader.comes("columns"));
    return list;
}

static Record read_record(Reader& reader) {
    Record record{.line = reader.line()};
    const bool minimal = reader.comes("minimal");
    record.numbers = reader.take(
        minimal ? "minimal # #" : "deficient # # rank # excess # # # star # $ delete rows");
    if (!minimal) {
        record.rows = read_ascending(reader, 999'999);
        reader.take("columns");
        record.columns = read_ascending(reader, camera_unknowns);
        reader.take("$ minor");
    }
    record.minor.value = static_cast<std::uint64_t>(reader.integer(1, modulus - 1));
    reader.end_line();
    for (int i = 0; !minimal && i < 11 && (i == 0 || reader.comes("kernel")); ++i) {
        reader.take("kernel");
        for (mpz_class& entry : record.kernel.emplace_back()) entry = reader.big_integer();
        reader.end_line();
    }
    return record;
}

/// Refuses kernel vectors that have not the form of the basis, or do not keep all images.
static void check_kernel(const Record& record, const std::vector<const Block*>& blocks) {
    for (std::size_t i = 0; i < record.kernel.size(); ++i) {
        const Motion& motion = record.kernel[i];
        const std::string name = say("kernel vector ", i + 1);
        for (std::size_t j = 0; j < record.columns.size(); ++j)
            if (sgn(motion[static_cast<std::size_t>(record.columns[j] - 1)]) != (i == j))
                throw Refused(name, " has not the form of a basis at deleted column ", j + 1);
        mpz_class divisor = 0;
        for (const mpz_class& entry : motion) divisor = gcd(divisor, entry);
        if (divisor != 1) throw Refused(name, " has entries with a common divisor");
        for (const Block* block : blocks)
            for (const Motion& c : block->conditions)
                if (std::inner_product(c.begin(), c.end(), motion.begin(), mpz_class(0)) != 0)
                    throw Refused(name, " does not keep all images");
    }
}

/// What a record proves.
static Verdict check(const Record& record, const Classification& classes,
                     const std::vector<Pool>& pools) {
    const auto number = static_cast<std::size_t>(record.numbers[0]);
    const auto place = static_cast<std::size_t>(record.numbers[1]) - 1;
    if (number >= classes.representatives.size()) throw Refused("there is no such class");
    if (place >= pools.size()) throw Refused("there is no such pool");
    const Signature& signature = classes.representatives[number];
    const Pool& pool = pools[place];
    if (!pool.holds) throw Refused("its pool is refused");
    std::vector<const Block*> blocks;
    std::int64_t rows = 0; // of J
    for (std::size_t i = 0; i < feature_count; ++i) {
        if (pool.instances[i] < signature[i])
            throw Refused("its pool has too few ", features[i].notation);
        for (std::size_t n = 0; n < signature[i]; ++n) blocks.push_back(&pool.blocks[i][n]);
        rows += signature[i] * features[i].equations;
    }
    const Obstruction truth = obstruction(signature);
    const auto& [a, b, c] = truth.excess;
    const unsigned d = truth.deficiency();
    const Numbers right{record.numbers[0], record.numbers[1], 11 - d, a, b, c, truth.star};
    if (record.kernel.empty() ? d > 0 : record.numbers != right)
        throw Refused("it has rank ", 11 - d, ", excess ", a, ' ', b, ' ', c, ", S ", truth.star);
    if (record.rows.size() != d || record.columns.size() != d || record.kernel.size() != d)
        throw Refused("there must be ", d, " deleted rows, deleted columns and kernel vectors");
    if (d > 0 && record.rows.back() > rows) throw Refused("J has only ", rows, " rows");
    const Residue value = minor(blocks, record.rows, record.columns);
    if (value != record.minor) throw Refused("the minor is ", value.value, " modulo q");
    check_kernel(record, blocks);
    return {number, record.line, truth};
}

FileReport replay(const Classification& classes, std::string_view name,
                  std::string_view bytes) try {
    FileReport report{.name = printable(name, 4096)};
    Reader reader(bytes);
    reader.take(say("plcert 1 classification $ modulus ", modulus, " $"));
    std::vector<Pool> pools;
    while (reader.comes("pool")) pools.push_back(read_pool(reader, pools.size() + 1, report));
    const auto count = static_cast<std::int64_t>(classes.representatives.size());
    std::int64_t due = 0; // the class whose record is due
    const auto miss = [&](std::int64_t end, std::size_t line) {
        for (; due < std::min(end, count); ++due)
            report.refuse(line, say("class ", due, ": there is no certificate"));
    };
    while (!reader.at_end()) {
        const Record record = read_record(reader);
        const std::int64_t number = record.numbers[0];
        if (number < due) throw Complaint{record.line, say("class ", number, " comes too late")};
        miss(number, record.line);
        due = number + 1;
        try {
            report.verdicts.push_back(check(record, classes, pools));
        } catch (const Refused& refused) {
            report.refuse(record.line, say("class ", number, ": ", refused.reason));
        }
    }
    miss(count, reader.line());
    return report;
} catch (const Complaint& error) {
    return {.name = printable(name, 4096), .conforms = false, .complaints = {error}};
}
} // namespace checker
