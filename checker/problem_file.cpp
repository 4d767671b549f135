// Problem files (FORMAT.md, section 7): the certificate of the verdict on any problem in two or
// three views. First the whole file is read, then everything in it is checked in order.
#include "checker/record.h"

#include <optional>

namespace checker {

/// A line `reduce`; without a result the feature is removed.
struct Step {
    std::size_t line = 0;
    std::size_t position = 0; // from 1
    std::string_view rule{};
    std::optional<Feature> result{};
};

/// A feature with its coordinates.
struct Placed {
    std::size_t line = 0;
    Feature feature{};
    Numbers vectors{};
};

struct ProblemFile {
    std::string_view spelling{};
    unsigned views = 0;
    std::vector<Feature> features{};
    std::vector<Step> steps{};
    std::size_t verdict_line = 0;
    std::string verdict{}; // `minimal`, `over-constrained 2`, ...
    std::string_view kind{},
        number; // of the record: its first word; as it is written. No record: empty
    Numbers cameras{};
    std::vector<Placed> pool{};
    Record record{}; // of a camera-minimal problem: `columns` are columns of J
};

/// How section 1 spells a feature in so many views.
static std::string spell(const Feature& feature, unsigned views) {
    std::string text, unseen;
    for (unsigned v = 0; v < views; ++v) {
        std::string seen = feature.point >> v & 1 ? "P" : "";
        for (unsigned i = 0; i < feature.pins; ++i)
            if (feature.pin[i] >> v & 1) seen += static_cast<char>('a' + i);
        text += (v > 0 ? "/" : "") + (seen.empty() ? "-" : seen);
    }
    if (!feature.free_line && feature.point == 0 && feature.pins < 2) unseen = "P";
    for (unsigned i = 0; i < feature.pins; ++i)
        if (feature.pin[i] == 0) unseen += static_cast<char>('a' + i);
    return unseen.empty() ? text : text + "(" + unseen + ")";
}

/// Takes a feature in `views` views, or, if that is 0, in as many as it has, two or three.
static Feature read_feature(const Reader& reader, std::string_view word, unsigned& views) {
    const auto slashes = static_cast<unsigned>(std::count(word.begin(), word.end(), '/'));
    if (views == 0 && (slashes == 1 || slashes == 2)) views = slashes + 1;
    const Feature feature = slashes > 2 ? Feature{} : observe(word);
    // Observing reads more than section 1 allows; there is one spelling for each feature.
    if (slashes + 1 != views || spell(feature, views) != word)
        reader.fail(word, say("a feature as section 1 spells it, in ", views, " views"));
    for (unsigned v = 0; v < views; ++v) {
        unsigned lines = 0;
        for (const Views pin : feature.pin) lines += pin >> v & 1;
        if (lines > 1 && !(feature.point >> v & 1))
            reader.fail(word, "a view that sees two lines to see their point (Definition 1)");
    }
    return feature;
}

static void read_problem(Reader& reader, ProblemFile& file) {
    reader.take("problem");
    file.spelling = reader.rest();
    for (bool first = true; first || !reader.at_end(); first = false) {
        if (!first) reader.take("+");
        std::string_view word = reader.word();
        std::size_t count = 1;
        if (const std::size_t star = word.find('*'); star != word.npos) {
            std::from_chars(word.data(), word.data() + star, count);
            if (count < 2 || count > 1000 || say(count, '*') != word.substr(0, star + 1))
                reader.fail(word, "a multiplicity from 2 to 1000 before `*`");
            word.remove_prefix(star + 1);
        }
        const Feature feature = read_feature(reader, word, file.views);
        if (!first && file.features.back().notation == word)
            reader.fail(word, "equal neighbours with a multiplicity");
        if (file.features.size() + count > 1000) reader.fail(word, "at most 1000 features");
        file.features.insert(file.features.end(), count, feature);
    }
    reader.end_line();
}

static void read_steps(Reader& reader, ProblemFile& file) {
    while (reader.comes("reduce")) {
        Step step{.line = reader.line()};
        reader.take("reduce");
        step.position = static_cast<std::size_t>(reader.integer(1, 1000));
        step.rule = reader.word();
        const std::string_view result = reader.word();
        if (result != "nothing") step.result = read_feature(reader, result, file.views);
        reader.end_line();
        file.steps.push_back(step);
    }
    file.verdict_line = reader.line();
    reader.take("verdict");
    file.verdict = reader.word();
    if (!reader.at_end()) file.verdict += say(' ', reader.integer(1, 999'999));
    reader.end_line();
}

static void read_evidence(Reader& reader, ProblemFile& file) {
    reader.take(say("modulus ", modulus, " $"));
    file.cameras = read_cameras(reader, 1, file.views);
    do {
        Placed placed{.line = reader.line()};
        reader.take("feature");
        placed.feature = read_feature(reader, reader.word(), file.views);
        placed.vectors = read_vectors(reader, placed.feature.pins);
        file.pool.push_back(std::move(placed));
        if (file.pool.size() > 1000) reader.fail("feature", "at most 1000 features in a pool");
    } while (reader.comes("feature"));
    const std::size_t line = reader.line();
    file.kind = reader.word();
    file.number = reader.word();
    reader.take("1");
    if (file.kind == "camera-minimal") {
        reader.take("$ delete columns");
        file.record.columns = read_ascending(reader, 999'999);
        reader.take("$ minor");
        file.record.minor = read_minor(reader);
    } else {
        if (file.kind != "minimal" && file.kind != "deficient")
            reader.fail(file.kind, "`minimal`, `camera-minimal` or `deficient`");
        file.record = read_record(reader, file.kind == "minimal");
    }
    file.record.line = line;
}

/// Whether two features differ at most by their spelling.
static bool same(const Feature& a, const Feature& b) {
    return a.free_line == b.free_line && a.pins == b.pins && a.point == b.point && a.pin == b.pin;
}

/// Whether the result of a step is this feature without one of its pins, of which `fits` holds.
template <class Fits>
static bool forgets_pin(const Feature& feature, const std::optional<Feature>& result, Fits fits) {
    for (unsigned i = 0; i < feature.pins && !feature.free_line && result; ++i) {
        Feature rest = feature;
        std::rotate(rest.pin.begin() + i, rest.pin.begin() + i + 1, rest.pin.end());
        rest.pin.back() = 0;
        --rest.pins;
        if (fits(feature.pin[i]) && same(rest, *result)) return true;
    }
    return false;
}

/// Whether the rule of a step applies to the feature with this result: the table of section 7.
static bool applies(const Step& step, const Feature& f, unsigned views) {
    const auto gone = !step.result;
    const int seen = std::popcount(f.pin[0]), points = std::popcount(f.point);
    const auto once = [&](Views pin) { return std::popcount(pin) == 1 && !(pin & ~f.point); };
    const auto twice = [&](Views pin) { return std::popcount(pin) == 2 && !(pin & ~f.point); };
    Feature line = f; // the pin by itself
    line.free_line = true;
    line.point = 0;
    const bool leaves_line = f.pins == 1 && step.result && same(line, *step.result);
    const auto end = f.pin.begin() + f.pins;
    if (step.rule == "unseen-line" && f.free_line) return gone && seen == 0;
    if (step.rule == "free-line") return gone && f.free_line && (seen == 1 || seen == 2);
    if (f.free_line) return false;
    if (step.rule == "unseen-line")
        return forgets_pin(f, step.result, [](Views pin) { return pin == 0; });
    if (step.rule == "pin-seen-once") return forgets_pin(f, step.result, once);
    if (step.rule == "pin-seen-twice") return forgets_pin(f, step.result, twice);
    if (step.rule == "unseen-point")
        return points == 0 && f.pins > 0 && std::count(f.pin.begin(), end, 0U) == 0 &&
               (f.pins == 1 ? leaves_line : gone);
    if (step.rule == "bare-point") return gone && f.pins == 0 && points <= 1;
    if (step.rule == "point-on-line")
        return views == 3 && points == 1 && f.pin[0] == 0b111 && leaves_line;
    if (step.rule != "point-and-pin" || !gone || points == 0) return false;
    if (views == 3) return points == 1 && f.pins == 1 && std::popcount(f.pin[0] & ~f.point) == 1;
    return std::any_of(f.pin.begin(), end, [&](Views pin) { return pin & ~f.point; }) &&
           std::none_of(f.pin.begin(), end,
                        [&](Views pin) { return pin == 0 || once(pin) || twice(pin); });
}

/// The features left by the steps.
static std::vector<Feature> reduced(const ProblemFile& file) {
    std::vector<Feature> list = file.features;
    for (const Step& step : file.steps) {
        if (step.position > list.size())
            throw Complaint{step.line, say("there is no feature ", step.position)};
        const auto place = list.begin() + std::int64_t(step.position - 1);
        if (!applies(step, *place, file.views))
            throw Complaint{step.line, say("this rule does not do that to ", place->notation)};
        if (step.result)
            *place = *step.result;
        else
            list.erase(place);
    }
    return list;
}

/// A problem that is reduced and lifted, and what section 7 derives from it.
struct Lifted {
    std::vector<Feature> features{}; // in order
    unsigned weight = 0, most_pins = 0;
    Signature signature{};
};

/// Lifts a problem; refuses one that is not reduced. By Theorems 3 and 5 of the paper (proofs/
/// problems.md), features to which no rule applies are, lifted, the 27, and stars that all see; in
/// two views, points that both see.
static Lifted lift(std::vector<Feature> list, unsigned views) {
    Lifted lifted;
    std::array<std::vector<Feature>, feature_count + 1> sorted{}; // from 1; large stars first
    for (Feature& f : list) {
        for (Views& pin : f.pin) // the first view that sees the point fixes a dangling pin
            if (std::popcount(pin) == 1 && !f.free_line) pin |= f.point & -f.point;
        const bool star = f.pins > 7 && f.point == 0b111 &&
                          std::count(f.pin.begin(), f.pin.end(), 0b111U) == f.pins;
        const std::size_t i = index_of(f.point, f.pin);
        const bool known =
            i < feature_count && features[i].pins == f.pins && features[i].free_line == f.free_line;
        if (views == 2 ? f.point != 0b11 || f.pins > 0 : !star && !known)
            throw Refused("a rule still applies to ", f.notation);
        lifted.weight += star ? f.pins + 3 : features[i].weight();
        lifted.most_pins = std::max(lifted.most_pins, f.pins);
        sorted[star ? 0 : i + 1].push_back(f);
        if (!star) ++lifted.signature[i];
    }
    for (const std::vector<Feature>& some : sorted)
        lifted.features.insert(lifted.features.end(), some.begin(), some.end());
    return lifted;
}

/// The blocks of the pool, whose features must be these. Of the columns of J, all blocks together,
/// leaves out those listed.
static std::vector<Block> blocks_of(const ProblemFile& file, const std::vector<Feature>& expected,
                                    const Numbers& deleted) {
    if (file.pool.size() != expected.size())
        throw Refused("the pool must have ", expected.size(), " features");
    std::vector<Block> blocks;
    std::int64_t column = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const auto& [line, feature, vectors] = file.pool[i];
        if (!same(feature, expected[i]))
            throw Complaint{line, "the feature must be " + spell(expected[i], file.views)};
        Rows rows = jacobian_rows(feature, vectors, file.cameras);
        std::size_t kept = 0;
        for (std::size_t c = 0; c < feature.unknowns(); ++c) {
            if (std::binary_search(deleted.begin(), deleted.end(), ++column)) continue;
            for (std::vector<mpz_class>& row : rows) std::swap(row[kept], row[c]);
            ++kept;
        }
        for (std::vector<mpz_class>& row : rows)
            row.erase(row.begin() + std::int64_t(kept), row.begin() + feature.unknowns());
        blocks.push_back(eliminate(kept, std::move(rows)));
    }
    if (!deleted.empty() && deleted.back() > column)
        throw Refused("J has only ", column, " columns of its own");
    return blocks;
}

/// Checks the file; what it proves goes into the report.
static void check(const ProblemFile& file, const Classification& classes, FileReport& report) {
    const bool two = file.views == 2;
    const Lifted lifted = lift(reduced(file), file.views);
    const unsigned cameras = two ? 5 : 11; // unknowns
    std::size_t unknowns = cameras, equations = 0;
    for (const Feature& f : file.features) {
        unknowns += f.unknowns();
        equations += f.equations;
    }
    const bool large_star = !two && lifted.most_pins > 7;
    Obstruction truth = two ? Obstruction{} : obstruction(lifted.signature);
    if (large_star) truth.star = 2;
    std::string kind = !truth.minimal()        ? "deficient"
                       : unknowns == equations ? "minimal"
                                               : "camera-minimal";
    std::string verdict = truth.minimal() ? kind : "obstructed";
    if (lifted.weight < cameras) verdict = say("under-constrained ", cameras - lifted.weight);
    if (lifted.weight > cameras) verdict = say("over-constrained ", lifted.weight - cameras);
    if (lifted.weight != cameras) kind = "";
    if (file.verdict != verdict) throw Complaint{file.verdict_line, "the verdict is " + verdict};
    if (file.kind != kind)
        throw Refused("this verdict needs ", kind.empty() ? "no evidence" : kind);

    if (!kind.empty()) {
        const auto number = class_of(classes, lifted.signature, false);
        const std::string spelled = two || large_star ? "-" : say(number);
        if (file.number != spelled) throw Refused("the number of the class is ", spelled);
        const Numbers absent = two ? Numbers{6, 7, 8, 9, 10, 11} : Numbers{};
        const bool all = kind == "camera-minimal"; // all rows of J, but not all columns
        const Numbers deleted = all ? file.record.columns : Numbers{};
        const std::vector<Block> blocks =
            blocks_of(file, kind == "deficient" ? lifted.features : file.features, deleted);
        std::vector<const Block*> pointers;
        for (const Block& block : blocks) pointers.push_back(&block);
        if (all && deleted.size() != unknowns - equations)
            throw Refused("there must be ", unknowns - equations, " deleted columns");
        Record record = file.record;
        if (all) record.columns.clear();
        check_record(record, truth, pointers, absent);
        if (spelled != "-") {
            report.verdicts.push_back({number, file.record.line, truth});
            verdict += ", class " + spelled;
        }
    }
    report.certified = verdict;
}

void replay_problem(Reader& reader, const Classification& classes, FileReport& report) {
    ProblemFile file;
    read_problem(reader, file);
    read_steps(reader, file);
    if (!reader.at_end()) read_evidence(reader, file);
    if (!reader.at_end()) reader.fail(reader.word(), "the end of the file");
    report.problem = printable(file.spelling, 4096);
    try {
        check(file, classes, report);
    } catch (const Refused& refused) {
        report.refuse(std::max(file.record.line, file.verdict_line), refused.reason);
    } catch (const Complaint& complaint) {
        report.refuse(complaint.line, complaint.reason);
    }
}

} // namespace checker
