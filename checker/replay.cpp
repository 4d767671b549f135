#include "checker/record.h"
#include "checker/sha256.h"

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

/// Takes lines as sha256sum writes them: a digest, two spaces, a name.
static void read_digests(std::string_view bytes, FileReport& report) {
    report.kind = "digests";
    for (std::size_t line = 1; !bytes.empty(); ++line) {
        const std::size_t end = bytes.find('\n');
        if (end < 67 || end > 66 + 4096 || bytes.find_first_not_of("0123456789abcdef") != 64 ||
            bytes.substr(64, 2) != "  ")
            throw Complaint{line, "expected a SHA-256 digest, two spaces, a name"};
        report.listed.emplace_back(bytes.substr(0, 64),
                                   printable(bytes.substr(66, end - 66), 4096));
        bytes.remove_prefix(end + 1);
    }
}

FileReport replay(const Classification& classes, std::string_view name, std::string_view bytes) {
    FileReport report{.name = printable(name, 4096), .sha256 = sha256(bytes)};
    try { // no try block of the whole function: GCC 12 then destroys the report that it returns
        if (bytes.find_first_not_of("0123456789abcdef") == 64) {
            read_digests(bytes, report);
            return report;
        }
        Reader reader(bytes);
        reader.take("plcert 1");
        report.kind = reader.comes("problem")   ? "problem"
                      : reader.comes("degrees") ? "degrees"
                      : reader.comes("bounds")  ? "bounds"
                                                : "classification";
        reader.take(report.kind + " $");
        (report.kind == "problem"   ? replay_problem
         : report.kind == "degrees" ? replay_degrees
         : report.kind == "bounds"  ? replay_bounds
                                    : replay_classification)(reader, classes, report);
    } catch (const Complaint& error) {
        return {.name = report.name, .conforms = false, .complaints = {error}};
    }
    return report;
}
} // namespace checker
