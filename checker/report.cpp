#include "checker/claims.h"

#include <algorithm>
#include <iomanip>
#include <utility>

namespace checker {
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
    c.lines = lines;
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

/// Compares the files with the digests in lists, where a name may be the end of a path.
static void compare_digests(std::vector<FileReport>& files) {
    for (FileReport& list : files)
        for (const auto& [digest, name] : list.listed) {
            bool given = false;
            for (FileReport& file : files) {
                if (!("/" + file.name).ends_with("/" + name)) continue;
                given = true;
                file.digest = say(file.sha256 == digest ? "as in " : "not as in ", list.name);
                if (file.sha256 != digest)
                    file.refuse(0, say("its SHA-256 digest is ", file.sha256, ", in ", list.name,
                                       " it is ", digest));
            }
            if (!given) list.unverified.push_back(name);
        }
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
    }
    return of_class;
}

Report summarize(const Classification& classes, std::vector<FileReport> files) {
    Report report{.files = std::move(files)};
    compare_digests(report.files);
    const auto proved = collect(classes, report);
    const bool complete = std::count(proved.begin(), proved.end(), nullptr) == 0;
    std::array<std::size_t, table.size()> counts{};
    std::vector<Claim> named;
    std::vector<Class> described;
    for (std::size_t n = 0; n < proved.size(); ++n) {
        const Signature& signature = classes.representatives[n];
        const Obstruction obstruction = proved[n] ? *proved[n] : Obstruction{};
        const Class c = describe(signature, obstruction, classes.swap_class[n] == n);
        for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += table[i].counts(c);
        described.push_back(c);
        if (!proved[n]) described.back().minimal = described.back().terminal = false;
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
    add_degree_claims(classes, described, complete, report);
    for (const FileReport& file : report.files)
        report.status = std::max(report.status, !file.conforms ? 2 : file.refused > 0 ? 1 : 0);
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
    for (const DegreeClaim& c : report.degrees) {
        if (!c.verdict.starts_with("differs")) continue;
        text += say(c.claim, "\n  Paper: ", c.paper, "; certified at least: ", c.certified,
                    "; certified exactly: ", c.exact, "; known exactly: ", c.known, "; ", c.verdict,
                    ".\n  Witness: ", c.witness.empty() ? "none, or itself" : c.witness, "\n\n");
    }
    return text.empty() ? "no count that these files cover differs from the paper\n" : text;
}

/// What was found of a file, in lines.
static std::string text(const FileReport& file) {
    std::ostringstream text;
    text << file.name << ": ";
    if (!file.conforms)
        text << "not a certificate file";
    else if (file.kind == "digests")
        text << file.listed.size() - file.unverified.size() << " digests compared";
    else if (file.kind == "degrees")
        text << file.degrees.size() << " degree records hold, " << file.refused << " refused";
    else if (file.kind == "bounds")
        text << file.templates << " templates hold, " << file.refused << " refused";
    else if (!file.certified.empty())
        text << "certified " << file.certified << ": " << file.problem;
    else
        text << file.verdicts.size() << " certificates hold, " << file.refused << " refused";
    if (!file.digest.empty()) text << "; digest " << file.digest;
    for (const std::string& name : file.unverified)
        text << "\n- not verified, as it was not given: " << name;
    for (const auto& [number, line, solutions, complete] : file.degrees)
        if (file.degrees.size() <= 20)
            text << "\n- class " << number << ": certified to have at least " << solutions
                 << " solutions; evidence that there are no more: " << (complete ? "yes" : "none");
    for (const auto& [solutions, problems] : file.at_most)
        text << "\n- certified: " << problems << " terminal problems have at most " << solutions
             << " solutions";
    return text.str() + '\n';
}

std::string text(const Report& report) {
    std::ostringstream lines;
    for (const FileReport& file : report.files) lines << text(file);
    const auto has_claims = [](const FileReport& file) {
        return file.problem.empty() && file.kind != "degrees" && file.kind != "bounds" &&
               file.kind != "digests";
    };
    const auto write = [&](const Claim& c) {
        lines << std::left << '\n'
              << std::setw(52) << c.claim << std::right << std::setw(8) << c.paper << std::setw(11)
              << c.certified << "  " << c.verdict;
    };
    if (std::any_of(report.files.begin(), report.files.end(), has_claims)) {
        write({"claim", "paper", "certified", "verdict"});
        std::for_each(report.claims.begin(), report.claims.end(), write);
        lines << '\n';
    }
    const auto write_degree = [&](const DegreeClaim& c) {
        lines << std::left << '\n'
              << std::setw(52) << c.claim << std::right << std::setw(8) << c.paper << std::setw(11)
              << c.certified << std::setw(10) << c.exact << std::setw(10) << c.known << "  "
              << c.verdict;
    };
    const auto has_degrees = [](const FileReport& file) { return !file.degrees.empty(); };
    if (std::none_of(report.files.begin(), report.files.end(), has_degrees)) return lines.str();
    if (report.degrees.empty())
        return lines.str() + "The degrees are not compared with the paper: no class of theirs is "
                             "certified to be minimal in this run.\n";
    write_degree({"camera-degrees", "claimed", "certified", "certified", "known", ""});
    write_degree({"", "exactly", "at least", "exactly", "exactly", ""});
    std::for_each(report.degrees.begin(), report.degrees.end(), write_degree);
    return lines.str() + '\n';
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
             << ", \"sha256\": " << std::quoted(file.sha256)
             << ", \"digest\": " << std::quoted(file.digest)
             << ", \"problem\": " << std::quoted(file.problem)
             << ", \"verdict\": " << std::quoted(file.certified)
             << ", \"certified\": " << file.verdicts.size() << ", \"refused\": " << file.refused
             << ", \"complaints\": [";
        const char* inner = "\n";
        for (const auto& [line, reason] : file.complaints)
            json << std::exchange(inner, ",\n") << "  {\"line\": " << line
                 << ", \"reason\": " << std::quoted(reason) << '}';
        json << "], \"degrees\": [";
        inner = "\n";
        for (const auto& [number, line, solutions, complete] : file.degrees)
            json << std::exchange(inner, ",\n") << "  {\"class\": " << number
                 << ", \"certified_at_least\": " << solutions
                 << ", \"evidence_complete\": " << (complete ? "true" : "false") << '}';
        json << "], \"templates\": " << file.templates << ", \"terminal_problems_at_most\": {";
        inner = "";
        for (const auto& [solutions, problems] : file.at_most)
            json << std::exchange(inner, ", ") << '"' << solutions << "\": " << problems;
        json << "}, \"not_verified\": [";
        inner = "";
        for (const std::string& name : file.unverified)
            json << std::exchange(inner, ", ") << std::quoted(name);
        json << "]}";
    }
    comma = "],\n\"claims\": [\n";
    for (const auto& [claim, paper, certified, verdict] : report.claims)
        json << std::exchange(comma, ",\n") << "{\"claim\": " << std::quoted(claim)
             << ", \"paper\": " << cell(paper) << ", \"certified\": " << cell(certified)
             << ", \"verdict\": " << std::quoted(verdict) << '}';
    comma = "],\n\"degree_claims\": [\n";
    for (const DegreeClaim& c : report.degrees)
        json << std::exchange(comma, ",\n") << "{\"claim\": " << std::quoted(c.claim)
             << ", \"claimed_exactly\": " << cell(c.paper)
             << ", \"certified_at_least\": " << cell(c.certified)
             << ", \"certified_exactly\": " << cell(c.exact)
             << ", \"known_exactly\": " << cell(c.known)
             << ", \"verdict\": " << std::quoted(c.verdict) << '}';
    comma = "],\n\"certified_exactly\": [\n";
    for (const auto& [number, degree] : report.exact)
        json << std::exchange(comma, ",\n") << '[' << number << ", " << degree << ']';
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
