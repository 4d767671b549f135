#include "checker/jacobian.h"
#include "checker/report.h"

#include <algorithm>
#include <numeric>

namespace checker {

template <class... Part>
[[noreturn]] static void refuse(const Part&... reason) {
    throw Refused{say(reason...)};
}

/// The instances of each feature that a class may use, and how many the file has.
struct Pool {
    std::array<std::vector<Block>, feature_count> blocks{};
    Signature instances{};
    bool holds = true;
};

/// A record as it is written; in a `minimal` one the lists are empty.
struct Record {
    std::size_t line = 0, number = 0, pool = 0;
    Numbers stated{}, rows{}, columns{}; // stated: rank, excesses, star
    Residue minor{};
    std::vector<Motion> kernel{};
};

static Pool read_pool(Reader& reader, std::size_t number, FileReport& report) {
    Pool pool;
    if (number > 99) reader.fail("pool", "at most 99 pools");
    reader.take(say("pool ", number));
    reader.end_line();
    std::array<Numbers, 2> cameras;
    for (std::size_t v = 0; v < 2; ++v) {
        cameras[v] = reader.take(say("camera ", v + 2, " quaternion @ @ @ @ translation @ @ @"));
        reader.end_line();
    }
    for (std::size_t i = 0, count = 0; count == 0 || reader.comes("feature"); ++count) {
        const std::size_t line = reader.line();
        if (count == 1000) reader.fail("feature", "at most 1000 features in a pool");
        reader.take("feature");
        const std::string_view name = reader.word();
        while (i < feature_count && features[i].notation != name)
            ++i;
        if (i == feature_count) reader.fail(name, "a feature, in the order of the table");
        std::vector<Numbers> vectors{reader.take("point @ @ @")};
        while (vectors.size() <= features[i].pins)
            vectors.push_back(reader.take("pin @ @ @"));
        reader.end_line();
        try {
            Rows rows = jacobian_rows(features[i], vectors, cameras);
            if (pool.instances[i]++ < camera_unknowns / features[i].weight())
                pool.blocks[i].push_back(eliminate(features[i].unknowns(), std::move(rows)));
        } catch (const Refused& refused) {
            report.refuse(line, say("pool ", number, ": ", refused.reason));
            pool.holds = false;
        }
    }
    return pool;
}

/// Strictly ascending numbers, at most as many as there are camera columns.
static Numbers read_ascending(Reader& reader, std::int64_t largest) {
    Numbers list;
    do
        list.push_back(reader.integer(list.empty() ? 1 : list.back() + 1, largest));
    while (list.size() < camera_unknowns && !reader.at_end() && !reader.comes("columns"));
    return list;
}

/// Takes a record about a class whose number is not below `least`.
static Record read_record(Reader& reader, std::size_t least) {
    Record record{.line = reader.line()};
    const bool minimal = reader.comes("minimal");
    if (!minimal && !reader.comes("deficient"))
        reader.fail(reader.word(), "`minimal` or `deficient`");
    reader.take(minimal ? "minimal" : "deficient");
    record.number = static_cast<std::size_t>(reader.integer(std::int64_t(least), 999'999));
    record.pool = static_cast<std::size_t>(reader.integer(1, 99));
    if (!minimal) {
        record.stated = reader.take("rank # excess # # # star #");
        reader.end_line();
        reader.take("delete rows");
        record.rows = read_ascending(reader, 999'999);
        reader.take("columns");
        record.columns = read_ascending(reader, camera_unknowns);
        reader.end_line();
        reader.take("minor");
    }
    record.minor.value = static_cast<std::uint64_t>(reader.integer(1, modulus - 1));
    reader.end_line();
    while (!minimal && record.kernel.size() < 11 &&
           (record.kernel.empty() || reader.comes("kernel"))) {
        reader.take("kernel");
        for (mpz_class& entry : record.kernel.emplace_back())
            entry = reader.big_integer();
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
                refuse(name, " must be ", i == j ? "positive" : "zero", " at column ",
                       record.columns[j]);
        mpz_class divisor = 0;
        for (const mpz_class& entry : motion)
            divisor = gcd(divisor, entry);
        if (divisor != 1) refuse(name, " has entries with a common divisor");
        for (const Block* block : blocks)
            for (const Motion& c : block->conditions)
                if (std::inner_product(c.begin(), c.end(), motion.begin(), mpz_class(0)) != 0)
                    refuse(name, " does not keep all images");
    }
}

/// The obstruction (or that there is none) that a record proves for its class.
static Obstruction check(const Record& record, const Classification& classes,
                         const std::vector<Pool>& pools) {
    if (record.number >= classes.representatives.size()) refuse("there is no such class");
    if (record.pool > pools.size()) refuse("there is no pool ", record.pool);
    const Signature& signature = classes.representatives[record.number];
    const Pool& pool = pools[record.pool - 1];
    if (!pool.holds) refuse("pool ", record.pool, " is refused");
    std::vector<const Block*> blocks;
    std::size_t rows = 0; // of J
    for (std::size_t i = 0; i < feature_count; ++i) {
        if (pool.instances[i] < signature[i])
            refuse("pool ", record.pool, " has too few ", features[i].notation);
        for (std::size_t n = 0; n < signature[i]; ++n)
            blocks.push_back(&pool.blocks[i][n]);
        rows += signature[i] * features[i].equations;
    }
    const Obstruction truth = obstruction(signature);
    const std::size_t d = truth.deficiency();
    const auto& [a, b, c] = truth.excess;
    if (record.stated.empty()
            ? d > 0
            : record.stated != Numbers{11 - truth.deficiency(), a, b, c, truth.star})
        refuse("the class has rank ", 11 - d, ", excess ", a, ' ', b, ' ', c, ", star ",
               truth.star);
    if (record.rows.size() != d || record.columns.size() != d || record.kernel.size() != d)
        refuse("there must be ", d, " deleted rows, deleted columns and kernel vectors");
    if (d > 0 && record.rows.back() > std::int64_t(rows)) refuse("J has only ", rows, " rows");
    const Residue value = minor(blocks, record.rows, record.columns);
    if (value != record.minor) refuse("the minor is ", value.value, " modulo q");
    check_kernel(record, blocks);
    return truth;
}

/// Replays a classification file.
static void replay(Reader& reader, const Classification& classes, FileReport& report) {
    reader.take("plcert 1 classification");
    reader.end_line();
    reader.take(say("modulus ", modulus));
    reader.end_line();
    std::vector<Pool> pools;
    while (reader.comes("pool"))
        pools.push_back(read_pool(reader, pools.size() + 1, report));
    std::size_t due = 0; // the class whose record is due
    const auto miss = [&](std::size_t end, std::size_t line) {
        for (; due < std::min(end, classes.representatives.size()); ++due)
            report.refuse(line, say("class ", due, " has no certificate"));
    };
    while (!reader.at_end()) {
        const Record record = read_record(reader, due);
        miss(record.number, record.line);
        due = record.number + 1;
        try {
            report.verdicts.push_back({record.number, record.line, check(record, classes, pools)});
        } catch (const Refused& refused) {
            report.refuse(record.line, say("class ", record.number, ": ", refused.reason));
        }
    }
    miss(classes.representatives.size(), reader.line());
}

void FileReport::refuse(std::size_t line, std::string reason) {
    if (refused++ < 20) complaints.push_back({line, std::move(reason)});
}

FileReport replay(const Classification& classes, std::string name, std::string_view bytes) {
    FileReport report{.name = std::move(name)};
    try {
        Reader reader(bytes);
        replay(reader, classes, report);
    } catch (const Complaint& error) {
        return {.name = report.name, .parsed = false, .complaints = {error}};
    }
    return report;
}

} // namespace checker
