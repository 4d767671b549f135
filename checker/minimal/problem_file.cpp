#include "checker/minimal/problem_file.h"

#include "checker/minimal/pool.h"
#include "checker/minimal/reduction.h"

namespace checker {
/// What section 7 derives from a problem.
struct Derived {
    Obstruction obstruction{};
    std::optional<std::size_t> number{}; // of the label class
    std::string verdict{};
    std::string proof{}; // the word that begins its record; empty if none is due
};

static Derived derive(const Written& given, const Lifted& lifted, const Classification& classes) {
    const int missing = camera_columns(given.problem) - static_cast<int>(lifted.weight);
    if (missing > 0) return {.verdict = say("under-constrained ", missing)};
    if (missing < 0) return {.verdict = say("over-constrained ", -missing)};
    Derived derived;
    if (lifted.large_star)
        derived.obstruction.star = 2; // 8 pins, as the weights add up
    else if (given.problem.view_count() == 3) {
        derived.obstruction = obstruction(lifted.signature);
        derived.number = number_of(classes, largest_relabeled(lifted.signature));
    }
    if (!derived.obstruction.minimal()) {
        derived.verdict = "obstructed";
        derived.proof = "deficient";
        return derived;
    }
    derived.verdict = surplus(given.problem) == 0 ? "minimal" : "camera-minimal";
    derived.proof = derived.verdict;
    return derived;
}

/// Takes the pool, whose features must be these: their parts of J.
static std::vector<Jacobian<mpz_class>> read_rows(Reader& reader, const Features& list,
                                                  unsigned views) {
    const std::vector<Numbers> cameras = read_cameras(reader, 1, views);
    std::vector<Jacobian<mpz_class>> parts;
    for (const Feature& feature : list) {
        const std::string spelling = spell(feature, views);
        if (!reader.comes("feature")) throw Refused("the pool lacks the feature ", spelling);
        reader.take("feature");
        if (reader.word() != spelling) throw Refused("the feature must be ", spelling);
        parts.push_back(rows_of(feature, views, {cameras, read_placement(reader, feature.pins)}));
    }
    if (reader.comes("feature")) throw Refused("the problem has no more features");
    return parts;
}

/// The contribution of a feature without some of its own columns, whose numbers in J are listed.
/// The first of its columns has the number `first`.
static Contribution contribution_without(const Numbers& deleted, Jacobian<mpz_class> j, int first) {
    std::size_t kept = 0; // columns, which move to the front
    for (std::size_t c = 0; c < j.own; ++c) {
        if (std::ranges::binary_search(deleted, first + static_cast<int>(c))) continue;
        for (std::vector<mpz_class>& row : j.rows)
            std::swap(row[kept], row[c]);
        ++kept;
    }
    for (std::vector<mpz_class>& row : j.rows)
        row.erase(row.begin() + std::ptrdiff_t(kept), row.begin() + std::ptrdiff_t(j.own));
    return contribution_of(kept, std::move(j.rows));
}

/// The contributions of the features, without the deleted columns.
static std::vector<Contribution>
contributions_without(const Numbers& deleted, const std::vector<Jacobian<mpz_class>>& parts) {
    std::vector<Contribution> contributions;
    int column = 1;
    for (const Jacobian<mpz_class>& part : parts) {
        contributions.push_back(contribution_without(deleted, part, column));
        column += static_cast<int>(part.own);
    }
    if (!deleted.empty() && deleted.back() >= column)
        throw Refused("J has ", column - 1, " own columns");
    return contributions;
}

/// Takes the rest of the file and replays it: the proof about these features, those of the lifted
/// problem if it is obstructed, else those of the given one, whose surplus is this.
static void check_proof(Reader& reader, const Derived& derived, const Features& list,
                        const Problem& given, int surplus) {
    reader.take(say("modulus ", modulus, " $"));
    const auto views = static_cast<unsigned>(given.view_count());
    const std::vector<Jacobian<mpz_class>> parts = read_rows(reader, list, views);
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
    if (std::ssize(deleted) != -surplus)
        throw Refused("there must be ", -surplus, " deleted columns");
    const std::vector<Contribution> contributions = contributions_without(deleted, parts);
    std::vector<const Contribution*> pointers;
    for (const Contribution& contribution : contributions)
        pointers.push_back(&contribution);
    check_record(record, derived.obstruction, pointers,
                 static_cast<std::size_t>(camera_columns(given)));
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
        const Written given = read_notation(reader, section_1);
        const auto views = static_cast<unsigned>(given.problem.view_count());
        file.problem = printable(given.notation, 4096);
        file.meaning = given.problem;
        file.canonical = canonical(views, given.features);
        const Lifted lifted = lift(reduce(reader, given.features, views), views);
        const Derived derived = derive(given, lifted, classes);
        reader.take("verdict");
        if (rest_of_line(reader) != derived.verdict)
            throw Refused("the verdict is ", derived.verdict);
        reader.end_line();
        if (derived.proof == "deficient")
            check_proof(reader, derived, lifted.features, given.problem, 0);
        else if (!derived.proof.empty())
            check_proof(reader, derived, given.features, given.problem, surplus(given.problem));
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
