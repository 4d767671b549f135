#include "checker/report/report.h"

#include <iomanip>

namespace checker {
/// A number of things, one or more: `1 record`, `2 records`.
static std::string counted(std::size_t number, std::string_view thing) {
    return say(number, ' ', thing, number == 1 ? "" : "s");
}

/// So many of these hold, so many are refused.
static std::string held(std::size_t number, std::string_view thing, std::size_t refused) {
    return say(counted(number, thing), number == 1 ? " holds, " : " hold, ", refused, " refused");
}

/// What was found of a file, by its kind: the rest of its line, and lines that begin with "- ".
static std::string finding(const Malformed&) {
    return "not a certificate file";
}

static std::string finding(const ClassificationFile& file) {
    return held(file.verdicts.size(), "certificate", file.refusals.count);
}

static std::string finding(const ProblemFile& file) {
    if (file.verdict.empty()) return "refused";
    const std::string number = file.of_class ? say(", class ", file.of_class->number) : "";
    return say("certified ", file.verdict, number, ": ", file.problem);
}

static std::string finding(const DegreeFile& file) {
    std::string text = held(file.bounds.size(), "degree record", file.refusals.count);
    constexpr std::size_t most_lines = 20;
    if (file.bounds.size() > most_lines) return text;
    for (const auto& [number, solutions, complete] : file.bounds)
        text += say("\n- class ", number, ": certified to have at least ",
                    counted(solutions, "solution"),
                    "; evidence that there are no more: ", complete ? "yes" : "none");
    return text;
}

static std::string finding(const BoundsFile& file) {
    return held(file.templates, "template", file.refusals.count);
}

static std::string finding(const DigestList& list) {
    return "a list of " + counted(list.files.size(), "digest");
}

static std::string text(const ReplayedFile& file, const Comparison& comparison) {
    const auto find = [](const auto& content) { return finding(content); };
    std::string text = say(file.name, ": ", std::visit(find, file.content));
    if (!comparison.digest.empty()) text += "; digest " + comparison.digest;
    for (const std::string& name : comparison.not_given)
        text += "\n- not verified, as it was not given: " + name;
    return text + '\n';
}

static std::string text(const UpperBoundCount& count) {
    std::string text = say("certified: ", count.by_templates + count.by_theorem,
                           " terminal problems have at most ", count.solutions, " solutions");
    if (count.by_theorem > 0) text += say(", ", count.by_theorem, " of them by theorem");
    return text + '\n';
}

static std::string table_of_counts(const Report& report) {
    std::ostringstream lines;
    const auto write = [&](const paper::Claim& c) {
        lines << '\n'
              << std::left << std::setw(58) << c.claim << std::right << std::setw(8) << c.claimed
              << std::setw(11) << c.certified << "  " << c.verdict;
    };
    write({"claim", "paper", "certified", "verdict", ""});
    for (const paper::Claim& claim : report.claims)
        write(claim);
    return lines.str() + '\n';
}

static std::string table_of_degrees(const Report& report) {
    std::ostringstream lines;
    const auto write = [&](const paper::DegreeClaim& c) {
        lines << '\n'
              << std::left << std::setw(58) << c.claim << std::right << std::setw(8) << c.claimed
              << std::setw(11) << c.at_least << std::setw(11) << c.exact << std::setw(12)
              << c.by_theorem << std::setw(9) << c.known << "  " << c.verdict;
    };
    write({"camera-degrees", "claimed", "certified", "certified", "of these", "known", "", ""});
    write({"", "exactly", "at least", "exactly", "by theorem", "exactly", "", ""});
    for (const paper::DegreeClaim& claim : report.degrees)
        write(claim);
    return lines.str() + "\n";
}

std::string text(const Report& report) {
    std::string result;
    bool has_classification = false, has_degrees = false;
    for (std::size_t i = 0; i < report.files.size(); ++i) {
        const ReplayedFile& file = report.files[i];
        result += text(file, report.comparisons[i]);
        has_classification |= std::holds_alternative<ClassificationFile>(file.content);
        const auto* degrees = std::get_if<DegreeFile>(&file.content);
        has_degrees |= degrees && !degrees->bounds.empty();
    }
    for (const UpperBoundCount& count : report.upper_bounds)
        result += text(count);
    if (has_classification) result += table_of_counts(report);
    if (!report.degrees.empty())
        result += table_of_degrees(report);
    else if (has_degrees)
        result += "The degrees are not compared with the paper: no class of theirs is certified to "
                  "be minimal in this run.\n";
    return result;
}

std::string errata(const Report& report) {
    std::string result;
    for (const paper::Claim& c : report.claims) {
        if (!c.verdict.starts_with("differs")) continue;
        result += say(c.claim, "\n  Paper: ", c.claimed, "; certified: ", c.certified, "; ",
                      c.verdict, ".\n");
        if (!c.counted.empty()) result += say("  Counted: ", c.counted, "\n");
        result += '\n';
    }
    for (const paper::DegreeClaim& c : report.degrees) {
        if (!c.verdict.starts_with("differs")) continue;
        result += say(c.claim, "\n  Paper: ", c.claimed, "; certified at least: ", c.at_least,
                      "; certified exactly: ", c.exact, "; known exactly: ", c.known, "; ",
                      c.verdict, ".\n");
        if (!c.witness.empty()) result += say("  Witness: ", c.witness, "\n");
        result += '\n';
    }
    if (result.empty()) return "no count that these files cover differs from the paper\n";
    return result;
}

std::string complaints(const Report& report) {
    std::string result;
    for (std::size_t i = 0; i < report.files.size(); ++i) {
        const ReplayedFile& file = report.files[i];
        if (const auto* malformed = std::get_if<Malformed>(&file.content)) {
            const auto& [line, reason] = malformed->complaint;
            result += say(file.name, ':', line, ": does not conform to FORMAT.md: ", reason, '\n');
        }
        const Refusals& refusals = refusals_of(file);
        for (const auto& [line, reason] : refusals.first)
            result += say(file.name, ':', line, ": refused: ", reason, '\n');
        if (refusals.count > refusals.first.size())
            result +=
                say(file.name, ": ", refusals.count - refusals.first.size(), " more refused\n");
        for (const std::string& objection : report.comparisons[i].objections)
            result += say(file.name, ":0: refused: ", objection, '\n');
    }
    return result;
}
} // namespace checker
