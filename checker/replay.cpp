#include "checker/jacobian.h"
#include "checker/report.h"

namespace checker {
namespace {

template <class... Part>
[[noreturn]] void refuse(const Part&... reason) {
    throw Refused{say(reason...)};
}

/// The instances of each feature that a class may use, and how many the file has.
struct Pool {
    std::array<std::vector<Block>, feature_count> blocks{};
    Signature instances{};
    bool holds = true;
};

/// A record as it is written; a `minimal` one has empty lists.
struct Record {
    std::size_t line = 0, number = 0, pool = 0;
    Residue minor{};
    Numbers rank_excess_star{}, rows{}, columns{};
    std::vector<Motion> kernel{};
};

Pool read_pool(Reader& reader, std::int64_t number, FileReport& report) {
    Pool pool;
    reader.take("pool");
    reader.integer(number, std::min<std::int64_t>(number, 99));
    reader.end_line();
    std::array<Numbers, 2> cameras;
    for (std::size_t v = 0; v < 2; ++v) {
        cameras[v] = reader.take(say("camera ", v + 2, " quaternion @ @ @ @ translation @ @ @"));
        reader.end_line();
    }
    for (std::size_t index = 0, count = 0; count == 0 || reader.comes("feature"); ++count) {
        const std::size_t line = reader.line();
        if (count == 1000) reader.fail("feature", "at most 1000 features in a pool");
        reader.take("feature");
        const std::string_view name = reader.word();
        while (index < feature_count && features[index].notation != name)
            ++index;
        if (index == feature_count) reader.fail(name, "a feature, in the order of the table");
        const Feature& f = features[index];
        std::vector<Numbers> vectors{reader.take("point @ @ @")};
        while (vectors.size() <= f.pins)
            vectors.push_back(reader.take("pin @ @ @"));
        reader.end_line();
        ++pool.instances[index];
        try {
            const Matrix<mpz_class> rows = jacobian_rows(f, vectors, cameras);
            if (pool.instances[index] <= camera_unknowns / f.weight())
                pool.blocks[index].push_back(eliminate(f.unknowns(), rows));
        } catch (const Refused& refused) {
            report.refuse(line, say("pool ", number, ": ", refused.reason));
            pool.holds = false;
        }
    }
    return pool;
}

/// Takes strictly ascending numbers, at most as many as there are camera columns.
Numbers read_ascending(Reader& reader, std::int64_t largest) {
    Numbers list;
    while (list.empty() ||
           (list.size() < camera_unknowns && !reader.at_end() && !reader.comes("columns")))
        list.push_back(reader.integer(list.empty() ? 1 : list.back() + 1, largest));
    return list;
}

/// Takes a record about a class whose number is not below `least`.
Record read_record(Reader& reader, std::size_t least) {
    Record record{.line = reader.line()};
    const std::string_view kind = reader.word();
    if (kind != "minimal" && kind != "deficient") reader.fail(kind, "`minimal` or `deficient`");
    record.number =
        static_cast<std::size_t>(reader.integer(static_cast<std::int64_t>(least), 999'999));
    record.pool = static_cast<std::size_t>(reader.integer(1, 99));
    if (kind == "deficient") {
        record.rank_excess_star = reader.take("rank # excess # # # star #");
        reader.end_line();
        reader.take("delete rows");
        record.rows = read_ascending(reader, 999'999);
        reader.take("columns");
        record.columns = read_ascending(reader, camera_unknowns);
        reader.end_line();
        reader.take("minor");
    }
    record.minor = {static_cast<std::uint64_t>(reader.take("%").front())};
    reader.end_line();
    const bool deficient = kind == "deficient";
    for (std::size_t i = 0; deficient && i < 11 && (i == 0 || reader.comes("kernel")); ++i) {
        reader.take("kernel");
        for (mpz_class& entry : record.kernel.emplace_back())
            entry = reader.big_integer();
        reader.end_line();
    }
    return record;
}

/// Refuses kernel vectors that have not the form of the basis, or do not keep all images.
void check_kernel(const Record& record, const std::vector<const Block*>& blocks) {
    for (std::size_t i = 0; i < record.kernel.size(); ++i) {
        const Motion& motion = record.kernel[i];
        for (std::size_t j = 0; j < record.columns.size(); ++j)
            if (sgn(motion[static_cast<std::size_t>(record.columns[j] - 1)]) != (i == j))
                refuse("kernel vector ", i + 1, " is not ", i == j ? "positive" : "zero",
                       " at column ", record.columns[j]);
        mpz_class divisor = 0;
        for (const mpz_class& entry : motion)
            divisor = gcd(divisor, entry);
        if (divisor != 1) refuse("the entries of kernel vector ", i + 1, " have a common divisor");
        for (const Block* block : blocks)
            if (!allows(*block, motion))
                refuse("kernel vector ", i + 1, " does not keep all images");
    }
}

/// What a record about the problem of this signature proves.
Verdict check(const Record& record, const Signature& signature, const std::vector<Pool>& pools) {
    if (record.pool > pools.size()) refuse("there is no pool ", record.pool);
    const Pool& pool = pools[record.pool - 1];
    if (!pool.holds) refuse("pool ", record.pool, " is refused");
    std::vector<const Block*> blocks;
    std::int64_t rows = 0;
    for (std::size_t i = 0; i < feature_count; ++i) {
        if (pool.instances[i] < signature[i])
            refuse("pool ", record.pool, " has too few features ", features[i].notation);
        for (std::size_t n = 0; n < signature[i]; ++n)
            blocks.push_back(&pool.blocks[i][n]);
        rows += signature[i] * features[i].equations;
    }
    const Obstruction truth = obstruction(signature);
    const std::size_t d = truth.deficiency();
    const auto& [a, b, c] = truth.excess;
    if (record.rank_excess_star.empty() && d > 0)
        refuse("the class is not minimal: ", truth.words());
    if (!record.rank_excess_star.empty() &&
        record.rank_excess_star != Numbers{11 - truth.deficiency(), a, b, c, truth.star})
        refuse("the class has ", truth.words());
    if (record.rows.size() != d || record.columns.size() != d || record.kernel.size() != d)
        refuse("there must be ", d, " deleted rows, deleted columns and kernel vectors");
    if (d > 0 && record.rows.back() > rows) refuse("J has only ", rows, " rows");
    const Residue value = minor(blocks, record.rows, record.columns);
    if (value != record.minor) refuse("the minor is ", value.value, " modulo q");
    check_kernel(record, blocks);
    return {record.number, record.line, truth};
}

void replay(Reader& reader, const Classification& classes, FileReport& report) {
    reader.take("plcert 1");
    const bool problem = reader.comes("problem");
    reader.take(problem ? "problem" : "classification");
    reader.end_line();
    std::string_view stated; // the notation of the problem
    if (problem) {
        reader.take("problem");
        stated = reader.rest();
        reader.end_line();
    }
    reader.take("modulus 2305843009213693951");
    reader.end_line();
    std::vector<Pool> pools;
    while (problem ? pools.empty() : reader.comes("pool"))
        pools.push_back(read_pool(reader, std::ssize(pools) + 1, report));
    if (problem) report.problem = pools.front().instances;
    const std::size_t count = classes.representatives.size();
    std::size_t due = 0; // the class whose record is due in a classification file
    const auto miss = [&](std::size_t end) {
        for (; !problem && due < std::min(end, count); ++due)
            report.refuse(reader.line(), say("class ", due, " has no certificate"));
    };
    while (problem ? due == 0 : !reader.at_end()) {
        const Record record = read_record(reader, due);
        miss(record.number);
        due = record.number + 1;
        try {
            if (record.number >= count) refuse("the classes are 0 to ", count - 1);
            if (problem && class_of(classes, *report.problem) != record.number)
                refuse("the problem is of another class");
            if (problem && notation(*report.problem) != stated)
                refuse("the features of the pool are ", notation(*report.problem));
            report.verdicts.push_back(check(
                record, problem ? *report.problem : classes.representatives[record.number], pools));
        } catch (const Refused& refused) {
            report.refuse(record.line, say("class ", record.number, ": ", refused.reason));
        }
    }
    miss(count);
    if (!reader.at_end()) reader.fail(reader.word(), "the end of the file");
}

} // namespace

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
