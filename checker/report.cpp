#include "checker/report.h"

#include <algorithm>
#include <iomanip>

namespace checker {
namespace {

/// What the claims are about. A minimal class that is the first of its swap&label class stands for
/// a terminal problem. If two views share five points, these determine their relative pose.
struct Class {
    Obstruction obstruction{};
    bool first = false, all_seen = true, five = false, registration = false;
    unsigned points = 0, lines = 0, pins = 0, most_pins = 0;

    bool minimal() const { return obstruction.minimal(); }
    bool terminal() const { return first && minimal(); }
    unsigned excess() const { return obstruction.epipolar(); }
    /// The name in PLMP, if all is seen; the second digit counts points on the lines of others.
    std::string name() const { return say(points, 0, lines, pins, '_', most_pins); }
};

/// Whether a pair of views sees the same lines of a feature and, if only one sees its point, the
/// other sees a pin of it: so that their relative pose determines all that a third view needs.
bool determined(const Feature& feature, Views pair) {
    for (const Views pin : feature.pin)
        if (std::popcount(pin & pair) == 1) return false;
    return std::popcount(feature.point & pair) != 1 || (feature.views & pair) == pair;
}

Class describe(const Signature& signature) {
    Class c;
    for (std::size_t i = 0; i < feature_count; ++i) {
        const unsigned pins = features[i].point == 0 ? 0 : features[i].pins;
        if (signature[i] == 0) continue;
        (features[i].point == 0 ? c.lines : c.points) += signature[i];
        c.pins += signature[i] * pins;
        c.most_pins = std::max(c.most_pins, pins);
        c.all_seen &= features[i].equations == 6 + 3 * pins; // the most that there can be
    }
    for (const Views pair : view_pairs) {
        if (shared_points(signature, pair) != 5) continue;
        bool scene = true;
        for (std::size_t i = 0; i < feature_count; ++i)
            scene &= signature[i] == 0 || determined(features[i], pair);
        c.five = true;
        c.registration |= scene;
    }
    return c;
}

/// A number of classes; 0 where the paper has none. Why the certified number is another, if it is.
struct Count {
    std::string_view claim;
    std::size_t paper;
    bool (*counts)(const Class&);
    std::string_view difference = "not explained";
};

constexpr std::string_view skipped =
    "the published script skips its list of re-checked classes (proofs/classification.md, 7)";
using C = const Class&;
constexpr std::array<Count, 13> table{{
    {"label classes, not minimal", 2878, [](C c) { return !c.minimal(); }},
    {"label classes, minimal", 140616, [](C c) { return c.minimal(); }},
    {"swap&label classes, not minimal", 1871, [](C c) { return c.first && !c.minimal(); }},
    {"terminal camera-minimal", 74575, [](C c) { return c.terminal(); }},
    {"reduced minimal PL0Ps (no pins)", 51, [](C c) { return c.minimal() && c.most_pins == 0; }},
    {"terminal, at most one pin a point", 9533,
     [](C c) { return c.terminal() && c.most_pins < 2; }},
    {"five-point extensions, minimal", 6300, [](C c) { return c.minimal() && c.five; }, skipped},
    {"- of these, camera registration", 61, [](C c) { return c.minimal() && c.registration; }},
    {"- terminal camera-minimal", 3648, [](C c) { return c.terminal() && c.five; }, skipped},
    {"minimal, complete visibility", 12, [](C c) { return c.minimal() && c.all_seen; }},
    {"not minimal by E > 0", 0, [](C c) { return c.excess() > 0; }},
    {"not minimal by S = 1 alone", 0, [](C c) { return !c.minimal() && c.excess() == 0; }},
    {"not minimal by both", 0, [](C c) { return c.excess() > 0 && c.obstruction.star == 1; }},
}};

/// The minimal problems of PLMP in three views with no line through two points.
constexpr std::string_view plmp = "3002_1 3002_2 3010_0 2005_3 2005_4 2005_5 "
                                  "2013_2 2013_3 2021_1 1024_4 1032_2 1040_0";

Claim compare(std::string_view claim, const std::string& paper, const std::string& certified,
              std::string_view difference = "not explained") {
    std::string verdict = say("differs: ", difference);
    if (certified == paper) verdict = "confirmed";
    if (paper == "-") verdict = "not in the paper";
    if (certified == "-") verdict = "not covered by these files";
    return {std::string(claim), paper, certified, verdict};
}

/// By class number, the obstruction that a certificate proves. Swaps do not change whether a
/// problem is minimal (Corollary 2 of the paper): refuses a verdict that contradicts an earlier
/// one.
std::vector<const Obstruction*> collect(const Classification& classes, Report& report) {
    std::vector<const Obstruction*> of_class(classes.swap_class.size()), of_swap_class(of_class);
    for (FileReport& file : report.files) {
        for (const Verdict& v : file.verdicts) {
            const Obstruction*& earlier = of_swap_class[classes.swap_class[v.number]];
            if (!earlier) earlier = &v.obstruction;
            if (earlier->minimal() == v.obstruction.minimal())
                of_class[v.number] = &v.obstruction;
            else
                file.refuse(v.line, say("class ", v.number, " contradicts its swap&label class"));
        }
        report.status = std::max(report.status, !file.parsed ? 2 : file.refused > 0 ? 1 : 0);
    }
    return of_class;
}

/// What became of a file, in words.
std::string outcome(const FileReport& file) {
    if (!file.parsed) return "not a certificate file";
    return say(file.verdicts.size(), " certificates hold, ", file.refused, " refusals");
}

/// JSON: null for `-`, a number if the text is one, and a string otherwise.
std::string value(std::string_view text) {
    if (text == "-") return "null";
    if (text.find_first_not_of("0123456789") == text.npos) return std::string(text);
    std::string json = "\"";
    for (const char c : text)
        json.append(c == '"' || c == '\\', '\\') += c;
    return json + '"';
}

/// JSON: the array of what `convert` makes of the items.
template <class Item, class Convert>
std::string array(const std::vector<Item>& items, const Convert& convert) {
    std::string json;
    for (const Item& item : items)
        json += (json.empty() ? "[\n" : ",\n") + convert(item);
    return json.empty() ? "[]" : json + "]";
}

} // namespace

Report summarize(const Classification& classes, std::vector<FileReport> files) {
    Report report{.files = std::move(files)};
    const auto proved = collect(classes, report);
    const bool complete = std::count(proved.begin(), proved.end(), nullptr) == 0;
    std::vector<Claim> named;
    std::array<std::size_t, table.size()> counts{};
    std::size_t swap_classes = 0;
    for (std::size_t n = 0; n < proved.size(); ++n) {
        Class c = describe(classes.representatives[n]);
        if (proved[n]) c.obstruction = *proved[n];
        c.first = classes.swap_class[n] == n;
        swap_classes += c.first;
        for (std::size_t i = 0; i < counts.size(); ++i)
            counts[i] += table[i].counts(c);
        if (!c.all_seen || plmp.find(c.name()) == plmp.npos) continue;
        const std::string problem =
            say(c.name(), ", class ", n, ": ", notation(classes.representatives[n]));
        named.push_back(compare(problem, "minimal",
                                !proved[n]    ? "-"
                                : c.minimal() ? "minimal"
                                              : "no"));
    }
    report.claims = {compare("balanced signatures", "845161", say(classes.signatures)),
                     compare("label classes", "143494", say(proved.size())),
                     compare("swap&label classes", "76446", say(swap_classes))};
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const auto& [claim, paper, unused, difference] = table[i];
        report.claims.push_back(compare(claim, paper == 0 ? "-" : say(paper),
                                        complete ? say(counts[i]) : "-", difference));
    }
    report.claims.insert(report.claims.end(), named.begin(), named.end());
    return report;
}

std::string text(const Report& report) {
    std::ostringstream text;
    for (const FileReport& file : report.files)
        text << printable(file.name, 4096) << ": " << outcome(file) << '\n';
    const auto write = [&](const Claim& c) {
        text << std::left << std::setw(52) << c.claim << std::right << std::setw(8) << c.paper
             << std::setw(11) << c.certified << "  " << c.verdict << '\n';
    };
    write({"\nclaim", "paper", "certified", "verdict"});
    for (const Claim& claim : report.claims)
        write(claim);
    return text.str();
}

std::string json(const Report& report) {
    const auto complaint = [](const Complaint& c) {
        return say("{\"line\": ", c.line, ", \"reason\": ", value(c.reason), '}');
    };
    const auto file = [&](const FileReport& f) {
        return say("{\"file\": ", value(printable(f.name, 4096)),
                   ", \"outcome\": ", value(outcome(f)), ", \"certified\": ", f.verdicts.size(),
                   ", \"refused\": ", f.refused,
                   ", \"complaints\": ", array(f.complaints, complaint), '}');
    };
    const auto claim = [](const Claim& c) {
        return say("{\"claim\": ", value(c.claim), ", \"paper\": ", value(c.paper),
                   ", \"certified\": ", value(c.certified), ", \"verdict\": ", value(c.verdict),
                   '}');
    };
    return say("{\"format\": 1, \"status\": ", report.status,
               ", \"files\": ", array(report.files, file),
               ", \"claims\": ", array(report.claims, claim), "}\n");
}

std::string complaints(const Report& report) {
    std::string text;
    for (const FileReport& file : report.files) {
        const std::string name = printable(file.name, 4096);
        for (const auto& [line, reason] : file.complaints)
            text += say(name, ':', line, file.parsed ? ": refused: " : ": syntax: ", reason, '\n');
        if (file.refused > file.complaints.size())
            text += say(name, ": ", file.refused - file.complaints.size(), " more refusals\n");
    }
    return text;
}

} // namespace checker
