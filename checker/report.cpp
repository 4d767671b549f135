#include "checker/report.h"

#include <algorithm>
#include <iomanip>
#include <utility>

namespace checker {
/// What the claims are about. The minimal classes that come first of their swap&label class stand
/// for the terminal problems.
struct Class {
    bool minimal, first, terminal;
    unsigned excess, star;                // E, S
    unsigned most_pins = 0;               // at a point
    bool five = false, registers = false; // two views share five points; and `determine` the rest
    std::string name{};                   // in PLMP, if every view sees everything
};

/// Whether a pair of views sees the same lines and, of each point that only one of it sees, the
/// other a pin: so their relative pose determines what is to be registered with the third.
static bool determine(Views pair, const Signature& signature) {
    for (std::size_t i = 0; i < feature_count; ++i) {
        if (signature[i] == 0) continue;
        for (const Views pin : features[i].pin)
            if (std::popcount(pin & pair) == 1) return false;
        if (std::popcount(features[i].point & pair) == 1 && (features[i].views & pair) != pair)
            return false;
    }
    return true;
}

static Class describe(const Signature& signature, const Obstruction& obstruction, bool first) {
    const bool minimal = obstruction.minimal();
    Class c{minimal, first, minimal && first, obstruction.epipolar(), obstruction.star};
    unsigned points = 0, lines = 0, pins = 0, equations = 0;
    for (std::size_t i = 0; i < feature_count; ++i) {
        equations += signature[i] * features[i].equations;
        (features[i].free_line ? lines : points) += signature[i];
        if (features[i].free_line || signature[i] == 0) continue;
        pins += signature[i] * features[i].pins;
        c.most_pins = std::max(c.most_pins, features[i].pins);
    }
    if (equations == 6 * (points + lines) + 3 * pins) // the most that there can be
        c.name = say(points, 0, lines, pins, '_', c.most_pins);
    for (const Views pair : view_pairs) {
        const bool five = shared_points(signature, pair) == 5;
        c.five |= five;
        c.registers |= five && determine(pair, signature);
    }
    return c;
}

/// A number of classes; 0 where the paper has none. Where the certified number is known to be
/// another: why, and what is counted, with a witness.
struct Count {
    std::string_view claim;
    std::size_t paper;
    bool (*counts)(const Class&);
    std::string_view difference = "not explained", definition = "as in the paper; no witness known";
};
using C = const Class&;
constexpr std::string_view skipped = "the authors' script skips its list of re-checked classes "
                                     "(proofs/classification.md, section 7)";
constexpr std::string_view five_points =
    "a minimal problem in which some two views share exactly five points, counted once for each "
    "label class, or, if terminal, for each swap&label class.\n  Witness: class 72050, 2*a/P/Pa + "
    "2*P/a/Pa + 3*-/P/P, is such a problem, and the script leaves it out. That it is minimal can "
    "be checked by hand: proofs/classification.md, section 7.";
constexpr std::array<Count, 15> table{{
    {"label classes", 143494, [](C) { return true; }},
    {"swap&label classes", 76446, [](C c) { return c.first; }},
    {"label classes, not minimal", 2878, [](C c) { return !c.minimal; }},
    {"label classes, minimal", 140616, [](C c) { return c.minimal; }},
    {"swap&label classes, not minimal", 1871, [](C c) { return c.first && !c.minimal; }},
    {"terminal camera-minimal", 74575, [](C c) { return c.terminal; }},
    {"reduced minimal PL0Ps (no pins)", 51, [](C c) { return c.minimal && c.most_pins == 0; }},
    {"terminal, at most one pin a point", 9533, [](C c) { return c.terminal && c.most_pins < 2; }},
    {"five-point extensions, minimal", 6300, [](C c) { return c.minimal && c.five; }, skipped,
     five_points},
    {"- of these, camera registration", 61, [](C c) { return c.minimal && c.registers; }},
    {"- terminal camera-minimal", 3648, [](C c) { return c.terminal && c.five; }, skipped,
     five_points},
    {"minimal, complete visibility", 12, [](C c) { return c.minimal && !c.name.empty(); }},
    {"not minimal: epipolar excess, E > 0", 0, [](C c) { return c.excess > 0; }},
    {"not minimal: a star alone, S = 1, E = 0", 0, [](C c) { return c.star > c.excess; }},
    {"not minimal: both, S = 1, E > 0", 0, [](C c) { return c.excess > 0 && c.star > 0; }},
}};

/// The problems that PLMP and the paper name.
constexpr std::string_view plmp = "3002_1 3002_2 3010_0 2005_3 2005_4 2005_5 2013_2 2013_3 "
                                  "2021_1 1024_4 1032_2 1040_0";

static Claim compare(std::string_view claim, const std::string& paper, const std::string& certified,
                     std::string_view difference = "not explained") {
    std::string verdict = say("differs: ", difference);
    if (certified == paper) verdict = "confirmed";
    if (paper == "-") verdict = "not in the paper";
    if (certified == "-") verdict = "not covered by these files";
    return {std::string(claim), paper, certified, verdict};
}

/// By class number, what a certificate proves. Swaps do not change whether a problem is minimal:
/// refuses a verdict that contradicts an earlier one on its swap&label class.
static std::vector<const Obstruction*> collect(const Classification& classes, Report& report) {
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
        report.status = std::max(report.status, !file.conforms ? 2 : file.refused > 0 ? 1 : 0);
    }
    return of_class;
}

Report summarize(const Classification& classes, std::vector<FileReport> files) {
    Report report{.files = std::move(files)};
    const auto proved = collect(classes, report);
    const bool complete = std::count(proved.begin(), proved.end(), nullptr) == 0;
    std::array<std::size_t, table.size()> counts{};
    std::vector<Claim> named;
    for (std::size_t n = 0; n < proved.size(); ++n) {
        const Signature& signature = classes.representatives[n];
        const Obstruction obstruction = proved[n] ? *proved[n] : Obstruction{};
        const Class c = describe(signature, obstruction, classes.swap_class[n] == n);
        for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += table[i].counts(c);
        if (c.name.empty() || plmp.find(c.name) == plmp.npos) continue;
        const std::string problem = say(c.name, ", class ", n, ": ", notation(signature));
        const std::string verdict = c.minimal ? "minimal" : "not minimal";
        named.push_back(compare(problem, "minimal", proved[n] ? verdict : "-"));
    }
    report.claims = {compare("balanced signatures", "845161", say(classes.signatures))};
    for (std::size_t i = 0; i < counts.size(); ++i) { // the first two are by enumeration alone
        const std::string certified = i < 2 || complete ? say(counts[i]) : "-";
        const std::string paper = table[i].paper == 0 ? "-" : say(table[i].paper);
        report.claims.push_back(compare(table[i].claim, paper, certified, table[i].difference));
    }
    report.claims.insert(report.claims.end(), named.begin(), named.end());
    return report;
}

std::string errata(const Report& report) {
    std::string text;
    for (const Claim& c : report.claims) {
        if (!c.verdict.starts_with("differs")) continue;
        const auto is = [&](const Count& count) { return count.claim == c.claim; };
        const auto* count = std::find_if(table.begin(), table.end(), is);
        text +=
            say(c.claim, "\n  Paper: ", c.paper, "; certified: ", c.certified, "; ", c.verdict,
                ".\n  Counted: ",
                count == table.end() ? "see the table" : std::string(count->definition), "\n\n");
    }
    return text.empty() ? "no count that these files cover differs from the paper\n" : text;
}

std::string text(const Report& report) {
    std::ostringstream text;
    for (const FileReport& file : report.files) {
        text << file.name << ": ";
        if (file.certified.empty())
            text << file.verdicts.size() << " certificates hold, "
                 << (file.conforms ? say(file.refused, " refused\n") : "not a certificate file\n");
        else
            text << "certified " << file.certified << ": " << file.problem << '\n';
    }
    const auto is_problem = [](const FileReport& file) { return !file.problem.empty(); };
    if (std::all_of(report.files.begin(), report.files.end(), is_problem)) return text.str();
    const auto write = [&](const Claim& c) {
        text << std::left << '\n'
             << std::setw(52) << c.claim << std::right << std::setw(8) << c.paper << std::setw(11)
             << c.certified << "  " << c.verdict;
    };
    write({"claim", "paper", "certified", "verdict"});
    std::for_each(report.claims.begin(), report.claims.end(), write);
    return text.str() + '\n';
}

/// A cell of the table in JSON: a number, null for `-`, or a string.
static std::string cell(const std::string& text) {
    const bool number = text.find_first_not_of("0123456789") == text.npos;
    return text == "-" ? "null" : number ? text : say(std::quoted(text));
}

std::string json(const Report& report) {
    std::ostringstream json;
    json << "{\"format\": 1, \"status\": " << report.status << ", \"files\": [";
    const char* comma = "\n";
    for (const FileReport& file : report.files) {
        json << std::exchange(comma, ",\n") << "{\"file\": " << std::quoted(file.name)
             << ", \"conforms\": " << (file.conforms ? "true" : "false")
             << ", \"problem\": " << std::quoted(file.problem)
             << ", \"verdict\": " << std::quoted(file.certified)
             << ", \"certified\": " << file.verdicts.size() << ", \"refused\": " << file.refused
             << ", \"complaints\": [";
        const char* inner = "\n";
        for (const auto& [line, reason] : file.complaints)
            json << std::exchange(inner, ",\n") << "  {\"line\": " << line
                 << ", \"reason\": " << std::quoted(reason) << '}';
        json << "]}";
    }
    comma = "],\n\"claims\": [\n";
    for (const auto& [claim, paper, certified, verdict] : report.claims)
        json << std::exchange(comma, ",\n") << "{\"claim\": " << std::quoted(claim)
             << ", \"paper\": " << cell(paper) << ", \"certified\": " << cell(certified)
             << ", \"verdict\": " << std::quoted(verdict) << '}';
    return json.str() + "]}\n";
}

std::string complaints(const Report& report) {
    std::ostringstream text;
    for (const FileReport& file : report.files) {
        const char* what = file.conforms ? ": refused: " : ": does not conform to FORMAT.md: ";
        for (const auto& [line, reason] : file.complaints)
            text << file.name << ':' << line << what << reason << '\n';
        if (file.refused > file.complaints.size())
            text << file.name << ": " << file.refused - file.complaints.size() << " more refused\n";
    }
    return text.str();
}
} // namespace checker
