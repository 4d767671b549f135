// Problem files (FORMAT.md, section 7): the certificate of the verdict on any problem in two or
// three views. The file is checked as it is read; what it should say next is derived before.
#include "checker/record.h"

#include <optional>

namespace checker {
using Features = std::vector<Feature>;

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

static Features read_problem(Reader& reader, unsigned& views) {
    Features list;
    do {
        if (!list.empty()) reader.take("+");
        std::string_view word = reader.word();
        std::size_t count = 1;
        if (const std::size_t star = word.find('*'); star != word.npos) {
            std::from_chars(word.data(), word.data() + star, count);
            if (count < 2 || count > 1000 || say(count, '*') != word.substr(0, star + 1))
                reader.fail(word, "a multiplicity from 2 to 1000 before `*`");
            word.remove_prefix(star + 1);
        }
        const Feature feature = read_feature(reader, word, views);
        if (!list.empty() && list.back().notation == word)
            reader.fail(word, "equal neighbours with a multiplicity");
        list.insert(list.end(), count, feature);
        if (list.size() > 1000) reader.fail(word, "at most 1000 features");
    } while (!reader.at_end());
    reader.end_line();
    return list;
}

/// Whether two features differ at most by their spelling.
static bool same(const Feature& a, const Feature& b) {
    return a.free_line == b.free_line && a.pins == b.pins && a.point == b.point && a.pin == b.pin;
}

/// Whether the result is this feature without one of its pins, of which `fits` holds.
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

/// Whether the rule turns the feature into the result, or into nothing: the table of section 7.
static bool applies(std::string_view rule, const Feature& f, const std::optional<Feature>& result,
                    unsigned views) {
    const int seen = std::popcount(f.pin[0]), points = std::popcount(f.point);
    const auto unseen = [&](Views pin) { return pin == 0; };
    const auto once = [&](Views pin) { return std::popcount(pin) == 1 && !(pin & ~f.point); };
    const auto twice = [&](Views pin) { return std::popcount(pin) == 2 && !(pin & ~f.point); };
    const auto alone = [&](Views pin) { return (pin & ~f.point) != 0; };
    const auto end = f.pin.begin() + f.pins;
    const Feature pin{{}, true, 0, f.pin[0], f.pin, f.pins}; // by itself, if it is the only one
    const bool gone = !result, leaves_line = f.pins == 1 && result && same(pin, *result);
    if (f.free_line)
        return gone && (rule == "unseen-line" ? seen == 0 : rule == "free-line" && seen % 3 > 0);
    if (rule == "unseen-line") return forgets_pin(f, result, unseen);
    if (rule == "pin-seen-once") return forgets_pin(f, result, once);
    if (rule == "pin-seen-twice") return forgets_pin(f, result, twice);
    if (rule == "unseen-point")
        return points == 0 && f.pins > 0 && std::none_of(f.pin.begin(), end, unseen) &&
               (f.pins == 1 ? leaves_line : gone);
    if (rule == "bare-point") return gone && f.pins == 0 && points <= 1;
    if (rule == "point-on-line") return views == 3 && points == 1 && seen == 3 && leaves_line;
    if (rule != "point-and-pin" || !gone || points == 0) return false;
    if (views == 3) return points == 1 && f.pins == 1 && std::popcount(f.pin[0] & ~f.point) == 1;
    return std::any_of(f.pin.begin(), end, alone) &&
           std::none_of(f.pin.begin(), end, [&](Views p) { return p == 0 || once(p) || twice(p); });
}

/// Takes the steps, and applies them to the list.
static void reduce(Reader& reader, Features& list, unsigned views) {
    while (reader.comes("reduce")) {
        reader.take("reduce");
        const auto position = static_cast<std::size_t>(reader.integer(1, 1000));
        const std::string_view rule = reader.word(), word = reader.word();
        std::optional<Feature> result;
        if (word != "nothing") result = read_feature(reader, word, views);
        if (position > list.size()) throw Refused("there is no feature ", position);
        const auto place = list.begin() + std::int64_t(position - 1);
        if (!applies(rule, *place, result, views))
            throw Refused("this is no rule for ", place->notation);
        if (result)
            *place = *result;
        else
            list.erase(place);
        reader.end_line();
    }
}

/// A problem that is reduced and lifted, and what section 7 derives from it.
struct Lifted {
    Features features{}; // in order
    unsigned weight = 0;
    bool large_star = false; // a point with 8 pins or more
    Signature signature{};   // of the other features
};

/// Lifts a problem; refuses one that is not reduced. By Theorems 3 and 5 of the paper (proofs/
/// problems.md), features to which no rule applies are, lifted, the 27, and stars that all see; in
/// two views, points that both see.
static Lifted lift(Features list, unsigned views) {
    Lifted lifted;
    std::array<Features, feature_count + 1> sorted{}; // large stars first
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
        if (!star) f.equations = features[i].equations; // more, if it was lifted
        lifted.weight += star ? f.pins + 3 : features[i].weight();
        sorted[star ? 0 : i + 1].push_back(f);
        lifted.large_star |= star;
        if (!star) ++lifted.signature[i];
    }
    for (const Features& some : sorted)
        lifted.features.insert(lifted.features.end(), some.begin(), some.end());
    return lifted;
}

/// Takes the features of the pool, which must be these: their rows of J.
static std::vector<Rows> read_pool(Reader& reader, const Features& problem, unsigned views) {
    const Numbers cameras = read_cameras(reader, 1, views);
    std::vector<Rows> rows;
    for (const Feature& feature : problem) {
        const std::string spelling = spell(feature, views);
        if (!reader.comes("feature")) throw Refused("the pool lacks the feature ", spelling);
        reader.take("feature");
        if (reader.word() != spelling) throw Refused("the feature must be ", spelling);
        rows.push_back(jacobian_rows(feature, read_vectors(reader, feature.pins), cameras));
    }
    if (reader.comes("feature")) throw Refused("the problem has no more features");
    return rows;
}

/// The blocks of features with these rows of J, without some of their own columns, which are
/// numbered from 1 in J.
static std::vector<Block> blocks_without(const Numbers& deleted, const Features& problem,
                                         std::vector<Rows> all) {
    std::vector<Block> blocks;
    std::int64_t column = 0;
    for (std::size_t i = 0; i < problem.size(); ++i) {
        const unsigned unknowns = problem[i].unknowns();
        std::size_t kept = 0; // columns, which move to the front
        for (std::size_t c = 0; c < unknowns; ++c) {
            if (std::binary_search(deleted.begin(), deleted.end(), ++column)) continue;
            for (auto& row : all[i]) std::swap(row[kept], row[c]);
            ++kept;
        }
        for (auto& row : all[i])
            row.erase(row.begin() + std::int64_t(kept), row.begin() + unknowns);
        blocks.push_back(eliminate(kept, std::move(all[i])));
    }
    if (!deleted.empty() && deleted.back() > column)
        throw Refused("J has ", column, " own columns");
    return blocks;
}

/// Takes the rest of the file, the evidence: for the features whose rank it is about.
static void check_evidence(Reader& reader, const std::string& kind, const std::string& number,
                           const Obstruction& truth, const Features& problem, unsigned views) {
    reader.take(say("modulus ", modulus, " $"));
    const std::vector<Rows> rows = read_pool(reader, problem, views);
    if (!reader.comes(kind)) throw Refused("the evidence must be ", kind);
    reader.take(kind);
    if (reader.word() != number) throw Refused("the number of the class is ", number);
    reader.take("1");
    Numbers deleted; // columns that are none of the cameras'
    if (kind == "camera-minimal") {
        reader.take("$ delete columns");
        deleted = read_ascending(reader, 999'999);
        reader.take("$ minor");
    }
    const Record record = read_record(reader, kind != "deficient");
    if (!reader.at_end()) reader.fail(reader.word(), "the end of the file");
    std::int64_t excess = views == 2 ? 5 : 11; // of the columns of J over its rows
    for (const Feature& f : problem) excess += std::int64_t(f.unknowns()) - f.equations;
    if (std::ssize(deleted) != excess) throw Refused("there must be ", excess, " deleted columns");
    const std::vector<Block> blocks = blocks_without(deleted, problem, rows);
    std::vector<const Block*> pointers;
    for (const Block& block : blocks) pointers.push_back(&block);
    check_record(record, truth, pointers, views == 2 ? Numbers{6, 7, 8, 9, 10, 11} : Numbers{});
}

void replay_problem(Reader& reader, const Classification& classes, FileReport& report) try {
    reader.take("problem");
    report.problem = printable(reader.rest(), 4096);
    unsigned views = 0;
    const Features given = read_problem(reader, views);
    Features list = given;
    reduce(reader, list, views);
    const Lifted lifted = lift(list, views);

    unsigned columns = views == 2 ? 5 : 11, rows = 0; // of J; so far the columns of the cameras
    const std::int64_t missing = std::int64_t(columns) - lifted.weight;
    for (const Feature& f : given) columns += f.unknowns(), rows += f.equations;
    Obstruction truth = views == 2 ? Obstruction{} : obstruction(lifted.signature);
    if (lifted.large_star) truth.star = 2;
    const std::string number =
        views == 2 || lifted.large_star ? "-" : say(class_of(classes, lifted.signature, false));
    const std::string kind = !truth.minimal()  ? "deficient"
                             : columns == rows ? "minimal"
                                               : "camera-minimal";
    const std::string verdict = missing > 0       ? say("under-constrained ", missing)
                                : missing < 0     ? say("over-constrained ", -missing)
                                : truth.minimal() ? kind
                                                  : "obstructed";
    reader.take("verdict");
    if (reader.rest() != verdict) throw Refused("the verdict is ", verdict);
    reader.take(verdict + " $");
    const std::size_t line = reader.line();
    if (missing == 0)
        check_evidence(reader, kind, number, truth, truth.minimal() ? given : lifted.features,
                       views);
    else if (!reader.at_end())
        reader.fail(reader.word(), "the end of the file: a dimension count needs no evidence");
    report.certified = verdict + (missing == 0 && number != "-" ? ", class " + number : "");
    if (missing == 0 && number != "-") report.verdicts.push_back({std::stoul(number), line, truth});
} catch (const Refused& refused) {
    report.refuse(reader.line(), refused.reason);
}
} // namespace checker
