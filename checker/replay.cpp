#include "checker/record.h"

namespace checker {
/// The instances of each feature that a class may use, and how many the file has.
struct Pool {
    std::array<std::vector<Block>, feature_count> blocks{};
    Signature instances{};
    bool holds = true;
};

static Pool read_pool(Reader& reader, std::size_t number, FileReport& report) {
    Pool pool;
    const Numbers cameras = read_cameras(reader, number, 3);
    for (std::size_t i = 0, count = 0; count == 0 || reader.comes("feature"); ++count) {
        const std::size_t line = reader.line();
        if (count == 1000) reader.fail("feature", "at most 1000 features in a pool");
        reader.take("feature");
        const std::string_view name = reader.word();
        while (i < feature_count && features[i].notation != name) ++i;
        if (i == feature_count) reader.fail(name, "a feature, in the order of the table");
        const Numbers vectors = read_vectors(reader, features[i].pins);
        if (!pool.holds) continue; // one fault of a pool is enough
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

/// The blocks of a class in a pool.
static std::vector<const Block*> blocks_of(const Signature& signature, const Pool& pool) {
    if (!pool.holds) throw Refused("its pool is refused");
    std::vector<const Block*> blocks;
    for (std::size_t i = 0; i < feature_count; ++i) {
        if (pool.instances[i] < signature[i])
            throw Refused("its pool has too few ", features[i].notation);
        for (std::size_t n = 0; n < signature[i]; ++n) blocks.push_back(&pool.blocks[i][n]);
    }
    return blocks;
}

void replay_classification(Reader& reader, const Classification& classes, FileReport& report) {
    reader.take(say("modulus ", modulus, " $"));
    std::vector<Pool> pools;
    while (reader.comes("pool")) pools.push_back(read_pool(reader, pools.size() + 1, report));
    const auto& all = classes.representatives;
    std::size_t due = 0; // the class whose record is due
    const auto miss = [&](std::size_t end, std::size_t line) {
        for (; due < std::min(end, all.size()); ++due)
            report.refuse(line, say("class ", due, ": there is no certificate"));
    };
    while (!reader.at_end()) {
        const bool minimal = reader.comes("minimal");
        const Numbers words = reader.take(minimal ? "minimal # #" : "deficient # #");
        const auto number = static_cast<std::size_t>(words[0]);
        const auto pool = static_cast<std::size_t>(words[1]) - 1;
        const Record record = read_record(reader, minimal);
        if (number < due) throw Complaint{record.line, say("class ", number, " comes too late")};
        miss(number, record.line);
        due = number + 1;
        try {
            if (number >= all.size()) throw Refused("there is no such class");
            if (pool >= pools.size()) throw Refused("there is no such pool");
            const Obstruction truth = obstruction(all[number]);
            check_record(record, truth, blocks_of(all[number], pools[pool]), {});
            report.verdicts.push_back({number, record.line, truth});
        } catch (const Refused& refused) {
            report.refuse(record.line, say("class ", number, ": ", refused.reason));
        }
    }
    miss(all.size(), reader.line());
}

FileReport replay(const Classification& classes, std::string_view name, std::string_view bytes) {
    FileReport report{.name = printable(name, 4096)};
    try { // no try block of the whole function: GCC 12 then destroys the report that it returns
        Reader reader(bytes);
        reader.take("plcert 1");
        const bool problem = reader.comes("problem");
        reader.take(problem ? "problem $" : "classification $");
        (problem ? replay_problem : replay_classification)(reader, classes, report);
    } catch (const Complaint& error) {
        return {.name = report.name, .conforms = false, .complaints = {error}};
    }
    return report;
}
} // namespace checker
