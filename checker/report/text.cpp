#include "checker/report/report.h"

#include "checker/conclusion/models.h"

#include <iomanip>

namespace checker {
std::string complaints(const ReplayedFile& file) {
    std::string result;
    if (const auto* unreadable = std::get_if<Unreadable>(&file.content))
        return say("plcheck: cannot read ", file.name, ": ", unreadable->reason, '\n');
    if (const auto* malformed = std::get_if<Malformed>(&file.content)) {
        const auto& [line, reason] = malformed->complaint;
        return say(file.name, ':', line, ": does not conform to FORMAT.md: ", reason, '\n');
    }
    const Refusals& refusals = refusals_of(file);
    for (const auto& [line, reason] : refusals.first)
        result += say(file.name, ':', line, ": refused: ", reason, '\n');
    if (refusals.count > refusals.first.size())
        result += say(file.name, ": ", refusals.count - refusals.first.size(), " more refused\n");
    return result;
}

std::string objections(const Report& report) {
    std::string result;
    for (std::size_t i = 0; i < report.findings.files.size(); ++i)
        for (const std::string& objection : report.findings.objections[i])
            result += say(report.findings.files[i].name, ":0: refused: ", objection, '\n');
    return result;
}

/// A line of the summary: what it is about, then what is certified.
static std::string summary_line(std::string_view about, const std::string& text) {
    std::ostringstream line;
    line << std::left << std::setw(10) << about << text << '\n';
    return line.str();
}

static std::string summary_of_classes(const Report& report) {
    const Verdicts& verdicts = report.findings.verdicts;
    std::size_t certified = 0, minimal = 0;
    for (std::size_t n = 0; n < verdicts.size(); ++n) {
        certified += verdicts[n].has_value();
        minimal += is_minimal(verdicts, n);
    }
    return summary_line("classes", say(certified, " of ", verdicts.size(),
                                       " label classes certified: ", minimal, " minimal, ",
                                       certified - minimal, " not minimal"));
}

static std::string in_words(const ExactDegree& exact) {
    return say(exact.degree, " solutions", exact.group.empty() ? "" : " with the group ",
               exact.group, ": class ", exact.number, ", ", exact.problem);
}

static std::string summary_of_exact(const Report& report) {
    constexpr std::size_t most_lines = 4;
    const auto is_proved = [](const auto& verdict) { return verdict.has_value(); };
    if (std::ranges::none_of(report.findings.verdicts, is_proved))
        return summary_line("exactly", "no degree: theorems are for classes certified minimal; "
                                       "add classification.plc");
    if (report.exact.empty()) return summary_line("exactly", "no degree: no bounds meet");
    std::string result;
    if (report.exact.size() > most_lines)
        return summary_line("exactly", say(report.exact.size(), " label classes"));
    for (const ExactDegree& exact : report.exact)
        result += summary_line("exactly", in_words(exact));
    return result;
}

static std::string summary_of_degrees(const Report& report) {
    std::size_t records = 0;
    for (const ReplayedFile& file : report.findings.files)
        if (const auto* degrees = std::get_if<DegreeFile>(&file.content))
            records += degrees->bounds.size();
    std::string result;
    if (records > 0)
        result =
            summary_line("at least", say("lower bounds by ", counted(records, "degree record")));
    result += summary_of_exact(report);
    for (const paper::DegreeClaim& row : report.degrees)
        if (row.claim == "terminal, of any degree")
            result += summary_line("", say(row.exact, " of ", row.claimed, " terminal problems"));
    return result;
}

/// How many rows begin so.
template <class Row>
static std::size_t rows_that(const std::vector<Row>& rows, std::string_view verdict) {
    const auto begins = [&](const Row& row) { return row.verdict.starts_with(verdict); };
    return static_cast<std::size_t>(std::ranges::count_if(rows, begins));
}

static std::string summary_of_paper(const Report& report) {
    std::string text = say(rows_that(report.claims, "confirmed"), " counts confirmed, ",
                           rows_that(report.claims, "differs"), " differ");
    if (!report.degrees.empty())
        text += say("; degrees: ", rows_that(report.degrees, "agrees"), " rows agree, ",
                    rows_that(report.degrees, "differs"), " differ");
    return summary_line("paper", text + " (see --errata)");
}

using Cells = std::vector<std::string>;

static constexpr std::size_t widest_line = 100;

/// The widths of columns, two blanks apart. The first one gets what the others leave of a line; of
/// a verdict like `differs: reason` only the word counts.
static std::vector<std::size_t> widths_of(const std::vector<Cells>& rows) {
    std::vector<std::size_t> widths(rows[0].size());
    for (const Cells& row : rows) {
        for (std::size_t c = 0; c + 1 < row.size(); ++c)
            widths[c] = std::max(widths[c], row[c].size());
        widths.back() = std::max(widths.back(), row.back().substr(0, row.back().find(": ")).size());
    }
    std::size_t others = 0;
    for (std::size_t c = 1; c < widths.size(); ++c)
        others += 2 + widths[c];
    widths[0] = std::min(widths[0], widest_line - others);
    return widths;
}

/// Rows of equal length, in columns: the first and the last from the left, numbers from the right.
/// A first cell that is too wide has a line of its own, and so has the reason of a verdict.
static std::string aligned(const std::vector<Cells>& rows) {
    const std::vector<std::size_t> widths = widths_of(rows);
    std::ostringstream lines;
    for (const Cells& row : rows) {
        std::ostringstream line;
        const bool fits = row[0].size() <= widths[0];
        if (!fits) lines << row[0] << '\n';
        line << std::left << std::setw(static_cast<int>(widths[0])) << (fits ? row[0] : "")
             << std::right;
        for (std::size_t c = 1; c + 1 < row.size(); ++c)
            line << "  " << std::setw(static_cast<int>(widths[c])) << row[c];
        const std::string& verdict = row.back();
        std::string end = (verdict.empty() ? "" : "  ") + verdict;
        if (line.str().size() + end.size() > widest_line) end.replace(end.find(": "), 2, "\n    ");
        lines << line.str() << end << '\n';
    }
    return lines.str();
}

static std::string table_of_counts(const std::vector<paper::Claim>& claims) {
    std::vector<Cells> rows{{"claim", "paper", "certified", "verdict"}};
    for (const paper::Claim& c : claims)
        rows.push_back({c.claim, c.claimed, c.certified, c.verdict});
    return aligned(rows);
}

static std::string certified_range(const paper::FamilyDegree& degree) {
    if (degree.at_most == 0) return degree.at_least > 0 ? say(">= ", degree.at_least) : "-";
    if (degree.at_least == 0) return say("<= ", degree.at_most);
    if (degree.at_least == degree.at_most) return say(degree.at_most);
    return say(degree.at_least, "..", degree.at_most);
}

static std::string table_of_degrees(const std::vector<paper::FamilyDegree>& degrees) {
    if (degrees.empty()) return "";
    std::vector<Cells> rows{{"degree", "claimed", "certified", "evidence", "verdict"}};
    for (const paper::FamilyDegree& d : degrees)
        rows.push_back({std::string(d.name), say("> ", d.claimed_above), certified_range(d),
                        say(d.evidence), std::string(d.verdict)});
    return aligned(rows) + '\n';
}

/// Numbers of certified solutions, and in brackets the number of problems that have each, and no
/// more certified.
static std::string list_of_lower_bounds(const std::map<std::size_t, std::size_t>& lower_bounds) {
    if (lower_bounds.empty()) return "";
    std::size_t problems = 0;
    std::string line, lines;
    for (const auto& [solutions, number] : lower_bounds) {
        problems += number;
        const std::string entry = say(' ', solutions, " (", number, "),");
        if (line.size() + entry.size() > widest_line) {
            lines += line + '\n';
            line.clear();
        }
        line += (line.empty() ? " " : "") + entry;
    }
    line.back() = '\n';
    return say("solutions certified for ", counted(problems, "minimal problem"),
               ", at least (number of problems):\n", lines, line, '\n');
}

static std::string tables_of_families(const Report& report) {
    std::string result;
    for (const paper::FamilyTable& table : report.families) {
        result += say("\nfamily ", table.family, '\n', table_of_counts(table.claims), '\n',
                      table_of_degrees(table.degrees), list_of_lower_bounds(table.lower_bounds));
        if (table.exact == 0) continue;
        result += say("exactly: the degrees of ", counted(table.exact, "minimal problem"), ", ",
                      table.exact_by_theorem, " of them by theorem\n");
        if (!table.groups.empty())
            result +=
                say("the groups of ", table.groups.size(), " of them, by fibres or theorem\n");
        result += '\n';
    }
    return result;
}

/// Of files of models, the one table that there is; empty without such files.
static std::string table_of_models(const Report& report) {
    std::vector<Cells> rows{{"model", "claimed", "at least", "at most", "group", "verdict"}};
    const auto number = [](std::size_t n) { return n == 0 ? "-" : say(n); };
    for (const auto& [text, model] : models_of(report.findings))
        rows.push_back({model.name, number(model.claimed), number(model.at_least),
                        model.at_most ? say(*model.at_most) : "-",
                        model.group().empty() ? "-" : model.group(),
                        report.findings.status > 0 ? "withheld: a file is refused"
                                                   : std::string(verdict_on(model))});
    return rows.size() > 1 ? '\n' + aligned(rows) : "";
}

std::string summary(const Report& report) {
    bool has_classification = false;
    for (const ReplayedFile& file : report.findings.files)
        has_classification |= std::holds_alternative<ClassificationFile>(file.content);
    std::string result;
    if (has_classification) result += summary_of_classes(report);
    if (!report.findings.degrees.empty()) result += summary_of_degrees(report);
    if (has_classification && report.findings.status == 0) result += summary_of_paper(report);
    return result + tables_of_families(report);
}

static std::string table_of_degrees(const Report& report) {
    std::vector<Cells> rows{{"camera-degrees", "claimed", "certified", "certified", ""},
                            {"", "exactly", "at least", "exactly", "verdict"}};
    for (const paper::DegreeClaim& c : report.degrees)
        rows.push_back({c.claim, c.claimed, c.at_least, c.exact, c.verdict});
    return aligned(rows);
}

std::string table(const Report& report) {
    std::string result;
    for (const ReplayedFile& file : report.findings.files) {
        const std::string bounds = lower_bounds(file);
        if (!bounds.empty()) result += '\n' + file.name + ':' + bounds + '\n';
    }
    const auto is_model = [](const ReplayedFile& file) {
        return std::holds_alternative<ModelFile>(file.content);
    };
    result += table_of_models(report);
    if (!result.empty() && std::ranges::all_of(report.findings.files, is_model))
        return result + '\n';
    result += '\n' + table_of_counts(report.claims);
    if (!report.degrees.empty()) result += '\n' + table_of_degrees(report);
    return result + '\n';
}

std::string errata(const Report& report) {
    std::string result;
    for (const paper::Claim& c : report.claims) {
        if (!c.verdict.starts_with("differs")) continue;
        result += say('\n', c.claim, "\n  Paper: ", c.claimed, "; certified: ", c.certified, "; ",
                      c.verdict, ".\n");
        if (!c.counted.empty()) result += say("  Counted: ", c.counted, "\n");
    }
    for (const paper::DegreeClaim& c : report.degrees) {
        if (!c.verdict.starts_with("differs")) continue;
        result += say('\n', c.claim, "\n  Paper: ", c.claimed, "; certified at least: ", c.at_least,
                      "; certified exactly: ", c.exact, "; ", c.verdict, ".\n");
        if (!c.witness.empty()) result += say("  Witness: ", c.witness, "\n");
    }
    if (result.empty()) return "no count that these files cover differs from the paper\n";
    return result + '\n';
}

std::string why(const Report& report) {
    std::string result;
    for (const std::string& step : report.judgement.why)
        result += "- " + step + '\n';
    return result;
}

/// The first names, and how many more there are.
static std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t most = 6;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
        text += (i == 0 ? "" : ", ") + names[i];
    return names.size() > most ? say(text, " and ", names.size() - most, " more") : text;
}

std::string conclusion(const Report& report) {
    const auto& [verified, statement, files, steps] = report.judgement;
    const std::string from = files.empty() ? "" : say(" (", listed(files), ')');
    return say(verified ? "VERIFIED: " : "NOT VERIFIED: ", statement, from, '\n');
}

std::string text(const Report& report) {
    std::string result;
    for (const ReplayedFile& file : report.findings.files)
        result += finding(file);
    return result + summary(report) + conclusion(report);
}

std::string complaints(const Report& report) {
    std::string result;
    for (const ReplayedFile& file : report.findings.files)
        result += complaints(file);
    return result + objections(report);
}
} // namespace checker
