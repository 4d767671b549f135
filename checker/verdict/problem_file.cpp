#include "checker/verdict/problem_file.h"

#include "checker/classification/pool.h"
#include "checker/verdict/reduction.h"

namespace checker {
/// What section 7 derives from a problem.
struct Derived {
    Obstruction obstruction{};
    std::optional<std::size_t> number{}; // of the label class
    std::string verdict{};
    std::string proof{}; // the word that begins its record; empty if none is due
};

static int camera_columns(unsigned views) {
    return views == 2 ? 5 : 11;
}

/// The number of columns of J less that of its rows.
static int excess_columns(const Problem& problem) {
    int excess = camera_columns(problem.views);
    for (const Feature& feature : problem.features)
        excess += static_cast<int>(feature.unknowns()) - static_cast<int>(feature.equations);
    return excess;
}

static Derived derive(const Problem& given, const Lifted& lifted, const Classification& classes) {
    const int missing = camera_columns(given.views) - static_cast<int>(lifted.weight);
    if (missing > 0) return {.verdict = say("under-constrained ", missing)};
    if (missing < 0) return {.verdict = say("over-constrained ", -missing)};
    Derived derived;
    if (lifted.large_star)
        derived.obstruction.star = 2; // 8 pins, as the weights add up
    else if (given.views == 3) {
        derived.obstruction = obstruction(lifted.signature);
        derived.number = number_of(classes, largest_relabeled(lifted.signature));
    }
    if (!derived.obstruction.minimal()) {
        derived.verdict = "obstructed";
        derived.proof = "deficient";
        return derived;
    }
    derived.verdict = excess_columns(given) == 0 ? "minimal" : "camera-minimal";
    derived.proof = derived.verdict;
    return derived;
}

/// Takes the pool, whose features must be those of the problem: their rows of J.
static std::vector<IntegerRows> read_rows(Reader& reader, const Problem& problem) {
    const Cameras cameras = cameras_of(read_cameras(reader, 1, problem.views));
    std::vector<IntegerRows> rows;
    for (const Feature& feature : problem.features) {
        const std::string spelling = spell(feature, problem.views);
        if (!reader.comes("feature")) throw Refused("the pool lacks the feature ", spelling);
        reader.take("feature");
        if (reader.word() != spelling) throw Refused("the feature must be ", spelling);
        const Placement placement = placement_of(read_placement(reader, feature.pins));
        rows.push_back(jacobian_rows(feature, placement, cameras));
    }
    if (reader.comes("feature")) throw Refused("the problem has no more features");
    return rows;
}

/// The block of a feature without some of its own columns, whose numbers in J are listed. The first
/// of its columns has the number `first`.
static Block block_without(const Numbers& deleted, const Feature& feature, IntegerRows rows,
                           int first) {
    std::size_t kept = 0; // columns, which move to the front
    for (std::size_t c = 0; c < feature.unknowns(); ++c) {
        const int number = first + static_cast<int>(c);
        if (std::binary_search(deleted.begin(), deleted.end(), number)) continue;
        for (IntegerRow& row : rows)
            std::swap(row[kept], row[c]);
        ++kept;
    }
    for (IntegerRow& row : rows)
        row.erase(row.begin() + std::ptrdiff_t(kept),
                  row.begin() + std::ptrdiff_t(feature.unknowns()));
    return eliminate(kept, std::move(rows));
}

/// The blocks of the features, without the deleted columns.
static std::vector<Block> blocks_without(const Numbers& deleted, const Problem& problem,
                                         const std::vector<IntegerRows>& rows) {
    std::vector<Block> blocks;
    int column = 1;
    for (std::size_t i = 0; i < problem.features.size(); ++i) {
        const Feature& feature = problem.features[i];
        blocks.push_back(block_without(deleted, feature, rows[i], column));
        column += static_cast<int>(feature.unknowns());
    }
    if (!deleted.empty() && deleted.back() >= column)
        throw Refused("J has ", column - 1, " own columns");
    return blocks;
}

/// Takes the rest of the file and replays it: the proof about this problem, which is the lifted one
/// if it is obstructed, and the given one otherwise.
static void check_proof(Reader& reader, const Derived& derived, const Problem& problem) {
    reader.take(say("modulus ", modulus, " $"));
    const std::vector<IntegerRows> rows = read_rows(reader, problem);
    if (!reader.comes(derived.proof)) throw Refused("the proof must be ", derived.proof);
    reader.take(derived.proof);
    const std::string number = derived.number ? say(*derived.number) : "-";
    if (reader.word() != number) throw Refused("the number of the class is ", number);
    reader.take("1");
    Numbers deleted; // own columns
    if (derived.proof == "camera-minimal") {
        reader.take("$ delete columns");
        deleted = read_ascending(reader, 999'999);
        reader.take("$ minor");
    }
    const Record record = read_record(reader, derived.proof != "deficient");
    if (!reader.at_end()) reader.fail(reader.word(), "the end of the file");
    const int excess = excess_columns(problem);
    if (std::ssize(deleted) != excess) throw Refused("there must be ", excess, " deleted columns");
    const std::vector<Block> blocks = blocks_without(deleted, problem, rows);
    std::vector<const Block*> pointers;
    for (const Block& block : blocks)
        pointers.push_back(&block);
    Numbers absent; // camera columns
    if (problem.views == 2) absent = {6, 7, 8, 9, 10, 11};
    check_record(record, derived.obstruction, pointers, absent);
}

/// Takes the words to come, joined by spaces; of more than a verdict can be, only the first.
static std::string rest_of_line(Reader& reader) {
    std::string words(reader.word());
    while (!reader.at_end() && words.size() < 100)
        words += say(' ', reader.word());
    return words;
}

ProblemFile replay_problem(Reader& reader, const Classification& classes) {
    ProblemFile file;
    try {
        reader.take("problem");
        const Problem given = read_problem(reader);
        file.problem = printable(given.notation, 4096);
        file.canonical = canonical(given);
        const Lifted lifted = lift(reduce(reader, given.features, given.views), given.views);
        const Derived derived = derive(given, lifted, classes);
        reader.take("verdict");
        if (rest_of_line(reader) != derived.verdict)
            throw Refused("the verdict is ", derived.verdict);
        reader.end_line();
        if (derived.proof == "deficient")
            check_proof(reader, derived, {.views = given.views, .features = lifted.features});
        else if (!derived.proof.empty())
            check_proof(reader, derived, given);
        else if (!reader.at_end())
            reader.fail(reader.word(), "the end of the file: a dimension count needs no proof");
        if (derived.number) file.of_class = Verdict{*derived.number, derived.obstruction};
        file.verdict = derived.verdict;
    } catch (const Refused& refused) {
        file.refusals.add(reader.line(), refused.reason);
    }
    return file;
}
} // namespace checker
