#include "checker/report.h"

#include <algorithm>
#include <iomanip>

namespace checker {

/// What the claims are about: for each line of the table below, whether it counts the class.
struct Class {
    bool minimal, first;                  // of its swap&label class: one terminal problem for each
    unsigned excess, star;                // E, S
    unsigned most_pins = 0;               // at a point
    bool five = false, registers = false; // two views share five points; see `describe`
    std::string plmp_name{};              // if every view sees everything
};

/// Whether the relative pose of a pair of views determines what a third view needs of a feature:
/// they see the same lines of it, and if only one sees its point, the other sees a pin.
static bool determines(Views pair, const Feature& feature) {
    for (const Views pin : feature.pin)
        if (std::popcount(pin & pair) == 1) return false;
    return std::popcount(feature.point & pair) != 1 || (feature.views & pair) == pair;
}

static Class describe(const Signature& signature, const Obstruction& obstruction, bool first) {
    Class c{.minimal = obstruction.minimal(),
            .first = first,
            .excess = obstruction.epipolar(),
            .star = obstruction.star};
    unsigned points = 0, lines = 0, pins = 0, equations = 0;
    std::array<bool, 3> scene{true, true, true}; // each pair of views determines
    for (std::size_t i = 0; i < feature_count; ++i) {
        const Feature& f = features[i];
        const unsigned point_pins = f.free_line ? 0 : f.pins;
        if (signature[i] == 0) continue;
        (f.free_line ? lines : points) += signature[i];
        pins += signature[i] * point_pins;
        equations += signature[i] * f.equations;
        c.most_pins = std::max(c.most_pins, point_pins);
        for (std::size_t p = 0; p < 3; ++p)
            scene[p] &= determines(view_pairs[p], f);
    }
    for (std::size_t p = 0; p < 3; ++p) {
        const bool five = shared_points(signature, view_pairs[p]) == 5;
        c.five |= five;
        c.registers |= five && scene[p];
    }
    if (equations == 6 * (points + lines) + 3 * pins) // every view sees everything
        c.plmp_name = say(points, 0, lines, pins, '_', c.most_pins);
    return c;
}

/// A number of classes; 0 where the paper has none. Why the certified number is another, if it is.
struct Count {
    std::string_view claim;
    std::size_t paper;
    bool (*counts)(const Class&);
    std::string_view difference = "not explained";
};
using C = const Class&;
constexpr std::string_view skipped =
    "the published script skips its list of re-checked classes (proofs/classification.md, 7)";
constexpr std::array<Count, 13> table{{
    {"label classes, not minimal", 2878, [](C c) { return !c.minimal; }},
    {"label classes, minimal", 140616, [](C c) { return c.minimal; }},
    {"swap&label classes, not minimal", 1871, [](C c) { return c.first && !c.minimal; }},
    {"terminal camera-minimal", 74575, [](C c) { return c.first && c.minimal; }},
    {"reduced minimal PL0Ps (no pins)", 51, [](C c) { return c.minimal && c.most_pins == 0; }},
    {"terminal, at most one pin a point", 9533,
     [](C c) { return c.first && c.minimal && c.most_pins < 2; }},
    {"five-point extensions, minimal", 6300, [](C c) { return c.minimal && c.five; }, skipped},
    {"- of these, camera registration", 61, [](C c) { return c.minimal && c.registers; }},
    {"- terminal camera-minimal", 3648, [](C c) { return c.first && c.minimal && c.five; },
     skipped},
    {"minimal, complete visibility", 12, [](C c) { return c.minimal && !c.plmp_name.empty(); }},
    {"not minimal by E > 0", 0, [](C c) { return c.excess > 0; }},
    {"not minimal by S = 1 alone", 0, [](C c) { return c.star > c.excess; }},
    {"not minimal by both", 0, [](C c) { return c.excess > 0 && c.star > 0; }},
}};

/// The problems that PLMP and the paper name.
constexpr std::string_view plmp_names = "3002_1 3002_2 3010_0 2005_3 2005_4 2005_5 2013_2 2013_3 "
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
        report.status = std::max(report.status, !file.parsed ? 2 : file.refused > 0 ? 1 : 0);
    }
    return of_class;
}

Report summarize(const Classification& classes, std::vector<FileReport> files) {
    Report report{.files = std::move(files)};
    const auto proved = collect(classes, report);
    const bool complete = std::count(proved.begin(), proved.end(), nullptr) == 0;
    std::array<std::size_t, table.size()> counts{};
    std::size_t swap_classes = 0;
    std::vector<Claim> named;
    for (std::size_t n = 0; n < proved.size(); ++n) {
        const Signature& signature = classes.representatives[n];
        const bool first = classes.swap_class[n] == n;
        const Class c = describe(signature, proved[n] ? *proved[n] : Obstruction{}, first);
        swap_classes += first;
        for (std::size_t i = 0; i < counts.size(); ++i)
            counts[i] += table[i].counts(c);
        if (c.plmp_name.empty() || plmp_names.find(c.plmp_name) == plmp_names.npos) continue;
        const std::string verdict = c.minimal ? "minimal" : "not minimal";
        named.push_back(compare(say(c.plmp_name, ", class ", n, ": ", notation(signature)),
                                "minimal", proved[n] ? verdict : "-"));
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
    for (const FileReport& file : report.files) {
        text << printable(file.name, 4096) << ": ";
        if (!file.verdict.empty())
            text << "certified " << file.verdict << ": " << printable(file.problem, 4096)
                 << (file.number.empty() ? "" : ", class ") << file.number << '\n';
        else
            text << file.verdicts.size() << " certificates hold, " << file.refused << " refused\n";
    }
    text << '\n';
    const auto write = [&](const Claim& c) {
        text << std::left << std::setw(52) << c.claim << std::right << std::setw(8) << c.paper
             << std::setw(11) << c.certified << "  " << c.verdict << '\n';
    };
    write({"claim", "paper", "certified", "verdict"});
    std::for_each(report.claims.begin(), report.claims.end(), write);
    return text.str();
}

/// A cell of the table in JSON: a number, null for `-`, or a string.
static std::string cell(const std::string& text) {
    const bool number = text.find_first_not_of("0123456789") == text.npos;
    return text == "-" ? "null" : number ? text : say(std::quoted(text));
}

/// Adds an object to a JSON array that is still open.
static void add(std::string& array,
                const std::vector<std::pair<const char*, std::string>>& members) {
    array += array == "[" ? "\n{" : ",\n{";
    for (const auto& [key, value] : members)
        array += say(&key == &members[0].first ? "" : ", ", std::quoted(key), ": ", value);
    array += '}';
}

std::string json(const Report& report) {
    std::string files = "[", complaints = "[", claims = "[";
    for (const FileReport& f : report.files) {
        const std::string name = say(std::quoted(printable(f.name, 4096)));
        add(files, {{"file", name},
                    {"problem", say(std::quoted(f.problem))},
                    {"verdict", say(std::quoted(f.verdict))},
                    {"certified", say(f.verdicts.size())},
                    {"refused", say(f.refused)}});
        for (const auto& [line, reason] : f.complaints)
            add(complaints,
                {{"file", name}, {"line", say(line)}, {"reason", say(std::quoted(reason))}});
    }
    for (const auto& [claim, paper, certified, verdict] : report.claims)
        add(claims, {{"claim", cell(claim)},
                     {"paper", cell(paper)},
                     {"certified", cell(certified)},
                     {"verdict", cell(verdict)}});
    return say("{\"format\": 1, \"status\": ", report.status, ", \"files\": ", files,
               "],\n\"complaints\": ", complaints, "],\n\"claims\": ", claims, "]}\n");
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
