#include "checker/report/report.h"

namespace checker {
/// A string in JSON. All strings of a report are printable ASCII and line feeds.
static std::string json_string(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c == '\n' ? "\\n" : std::string(1, c);
    }
    return quoted + '"';
}

/// The items in brackets, a line each.
static std::string array_of(const std::vector<std::string>& items) {
    std::string text = "[";
    for (std::size_t i = 0; i < items.size(); ++i)
        text += (i == 0 ? "\n  " : ",\n  ") + items[i];
    return text + "]";
}

/// A cell of a table: a number, null for `-`, or a string.
static std::string cell(const std::string& text) {
    if (text == "-") return "null";
    const bool number = text.find_first_not_of("0123456789") == text.npos;
    return number ? text : json_string(text);
}

static std::string_view truth(bool value) {
    return value ? "true" : "false";
}

static std::vector<std::string> quoted(const std::vector<std::string>& texts) {
    std::vector<std::string> items;
    for (const std::string& text : texts)
        items.push_back(json_string(text));
    return items;
}

static std::string complaint(std::size_t line, const std::string& reason) {
    return say("{\"line\": ", line, ", \"reason\": ", json_string(reason), "}");
}

/// What is wrong with a file: the violation of the grammar, the first refusals, the objections.
static std::vector<std::string> complaints_of(const ReplayedFile& file,
                                              const std::vector<std::string>& objections) {
    std::vector<std::string> items;
    if (const auto* malformed = std::get_if<Malformed>(&file.content))
        items.push_back(complaint(malformed->complaint.line, malformed->complaint.reason));
    if (const auto* unreadable = std::get_if<Unreadable>(&file.content))
        items.push_back(complaint(0, "cannot be read: " + unreadable->reason));
    for (const auto& [line, reason] : refusals_of(file).first)
        items.push_back(complaint(line, reason));
    for (const std::string& objection : objections)
        items.push_back(complaint(0, objection));
    return items;
}

/// The members that only this kind of file has.
static std::string members(const Malformed&) {
    return "";
}

static std::string members(const Unreadable&) {
    return "";
}

static std::string members(const ClassificationFile& file) {
    return say(", \"certified\": ", file.verdicts.size());
}

static std::string members(const ProblemFile& file) {
    std::string verdict = file.verdict;
    if (!verdict.empty() && file.of_class) verdict += say(", class ", file.of_class->number);
    return say(", \"problem\": ", json_string(file.problem),
               ", \"verdict\": ", json_string(verdict));
}

static std::string members(const DegreeFile& file) {
    std::vector<std::string> items;
    for (const LowerBound& bound : file.bounds)
        items.push_back(
            say("{\"class\": ", bound.number, ", \"certified_at_least\": ", bound.solutions, "}"));
    return ", \"degrees\": " + array_of(items);
}

static std::string members(const ProblemsFile& file) {
    std::vector<std::string> items;
    for (const auto& [notation, problem, minimal] : file.verdicts)
        items.push_back(
            say("{\"problem\": ", json_string(notation), ", \"minimal\": ", truth(minimal), "}"));
    return say(", \"family\": ", json_string(file.family), ", \"missing\": ", file.missing,
               ", \"problems\": ", array_of(items));
}

static std::string members(const SolutionsFile& file) {
    std::vector<std::string> items;
    for (const auto& [notation, problem, solutions, cycle_types] : file.counts)
        items.push_back(say("{\"problem\": ", json_string(notation),
                            ", \"certified_at_least\": ", solutions, "}"));
    return ", \"solutions\": " + array_of(items);
}

static std::string members(const AtMostFile& file) {
    std::vector<std::string> items;
    for (const auto& [notation, problem, at_most] : file.bounds)
        items.push_back(say("{\"problem\": ", json_string(notation),
                            ", \"certified_at_most\": ", at_most, "}"));
    return ", \"upper_bounds\": " + array_of(items);
}

static std::string members(const ModelFile& file) {
    return say(", \"model\": ", json_string(file.name),
               ", \"claimed\": ", file.claimed == 0 ? "null" : say(file.claimed),
               ", \"certified_at_least\": ", file.at_least,
               ", \"certified_at_most\": ", file.at_most ? say(*file.at_most) : "null",
               ", \"certified_group\": ", cell(file.group().empty() ? "-" : file.group()),
               ", \"records\": ", file.records);
}

static std::string item(const ReplayedFile& file, const std::vector<std::string>& objections) {
    const auto own = [](const auto& content) { return members(content); };
    return say("{\"file\": ", json_string(file.name), ", \"kind\": ", json_string(kind_of(file)),
               ", \"conforms\": ", truth(!kind_of(file).empty()),
               ", \"sha256\": ", json_string(file.sha256), std::visit(own, file.content),
               ", \"refused\": ", refusals_of(file).count + objections.size(),
               ", \"complaints\": ", array_of(complaints_of(file, objections)), "}");
}

static std::string item(const paper::Claim& c) {
    return say("{\"claim\": ", json_string(c.claim), ", \"paper\": ", cell(c.claimed),
               ", \"certified\": ", cell(c.certified), ", \"verdict\": ", json_string(c.verdict),
               ", \"counted\": ", json_string(c.counted), "}");
}

static std::string item(const paper::FamilyDegree& d) {
    return say("{\"problem\": ", json_string(d.problem), ", \"name\": ", json_string(d.name),
               ", \"claimed_above\": ", d.claimed_above, ", \"certified_at_least\": ", d.at_least,
               ", \"certified_at_most\": ", d.at_most, ", \"evidence\": ", d.evidence,
               ", \"verdict\": ", json_string(d.verdict), "}");
}

static std::string item(const paper::FamilyTable& table) {
    std::vector<std::string> claims;
    for (const paper::Claim& claim : table.claims)
        claims.push_back(item(claim));
    std::vector<std::string> bounds;
    std::vector<std::string> degrees;
    for (const paper::FamilyDegree& degree : table.degrees)
        degrees.push_back(item(degree));
    std::vector<std::string> groups;
    for (const auto& [solutions, problems] : table.lower_bounds)
        bounds.push_back(say("[", solutions, ", ", problems, "]"));
    for (const auto& [problem, group] : table.groups)
        groups.push_back(say("[", json_string(problem), ", ", json_string(group), "]"));
    return say("{\"family\": ", json_string(table.family), ", \"claims\": ", array_of(claims),
               ", \"degrees\": ", array_of(degrees), ", \"lower_bounds\": ", array_of(bounds),
               ", \"exact\": ", table.exact, ", \"exact_by_theorem\": ", table.exact_by_theorem,
               ", \"certified_groups\": ", array_of(groups), "}");
}

static std::string item(const paper::DegreeClaim& c) {
    return say(
        "{\"claim\": ", json_string(c.claim), ", \"claimed_exactly\": ", cell(c.claimed),
        ", \"certified_at_least\": ", cell(c.at_least), ", \"certified_exactly\": ", cell(c.exact),
        ", \"verdict\": ", json_string(c.verdict), ", \"witness\": ", json_string(c.witness), "}");
}

static std::string item(const ExactDegree& exact) {
    return say("[", exact.number, ", ", exact.degree, "]");
}

/// The classes whose group is known: number, group.
static std::vector<std::string> groups_of(const std::vector<ExactDegree>& degrees) {
    std::vector<std::string> items;
    for (const ExactDegree& exact : degrees)
        if (!exact.group.empty())
            items.push_back(say("[", exact.number, ", ", json_string(exact.group), "]"));
    return items;
}

template <class Item> static std::string array_of(const std::vector<Item>& list) {
    std::vector<std::string> items;
    for (const Item& one : list)
        items.push_back(item(one));
    return array_of(items);
}

static std::string item(const Judgement& judgement) {
    return say("{\"verified\": ", truth(judgement.verified),
               ", \"statement\": ", json_string(judgement.statement),
               ", \"files\": ", array_of(quoted(judgement.files)),
               ", \"why\": ", array_of(quoted(judgement.why)), "}");
}

std::string json(const Report& report) {
    const Findings& findings = report.findings;
    std::vector<std::string> files;
    for (std::size_t i = 0; i < findings.files.size(); ++i)
        files.push_back(item(findings.files[i], findings.objections[i]));
    return say("{\"format\": 2, \"status\": ", report.status,
               ",\n\"conclusion\": ", item(report.judgement), ",\n\"files\": ", array_of(files),
               ",\n\"claims\": ", array_of(report.claims),
               ",\n\"families\": ", array_of(report.families),
               ",\n\"degree_claims\": ", array_of(report.degrees),
               ",\n\"certified_exactly\": ", array_of(report.exact),
               ",\n\"certified_groups\": ", array_of(groups_of(report.exact)), "}\n");
}
} // namespace checker
